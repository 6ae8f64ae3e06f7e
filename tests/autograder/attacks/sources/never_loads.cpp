namespace {
int wait() {
  for (volatile int i = 0;; i = i + 1) {
  }
}
const int waited = wait();
}  // namespace
