constexpr int burn(int depth) { return depth == 0 ? 1 : burn(depth - 1) + burn(depth - 1); }
static_assert(burn(60) > 0);
