template <int n>
struct Bomb {
  static constexpr int value = Bomb<n + 1>::value + Bomb<n + 2>::value;
};
int explode();
int explode() { return Bomb<0>::value; }
