namespace {
int fail() { throw 1; }
const int failed = fail();
}  // namespace
