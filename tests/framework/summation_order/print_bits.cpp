// Prints a hash of the bits that sums, norms and products of random numbers have. tests.cmake
// compiles it with and without Eigen's vector code, and compares the output.
#include <bit>
#include <cstdio>
#include <initializer_list>

#include "cs550/math.hpp"

namespace {

using namespace cs550;

/// Numbers from −1 to 1 (Lehmer 1951, with the multiplier of MINSTD).
class Numbers {
 public:
  Real next() {
    state_ = 48271ULL * state_ % 2147483647ULL;
    return static_cast<Real>(static_cast<double>(state_) / 1073741823.5 - 1);
  }
  template <int Rows, int Columns>
  void fill(Eigen::Matrix<Real, Rows, Columns, Eigen::DontAlign>& matrix) {
    for (Real& number : matrix.reshaped()) number = next();
  }

 private:
  std::uint64_t state_ = 1;
};

class Hash {
 public:
  void add(std::initializer_list<Real> numbers) {
    for (const Real number : numbers) {
      value_ = (value_ ^ std::bit_cast<std::uint32_t>(number)) * 1099511628211ULL;
    }
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

void add_quaternions(Numbers& numbers, Hash& hash) {
  Quat a, b;
  numbers.fill(a.coeffs());
  numbers.fill(b.coeffs());
  const Quat product = a * b, unit = a.normalized(), inverse = b.inverse();
  hash.add({product.w(), product.x(), product.y(), product.z(), unit.x(), inverse.y()});
  hash.add({a.norm(), a.dot(b), (a.coeffs() - b.coeffs()).squaredNorm()});
  hash.add({unit.toRotationMatrix()(0, 2), (unit * Vec3(1, 2, 3)).y()});
}

void add_matrices(Numbers& numbers, Hash& hash) {
  Mat3 m;
  Mat2 small;
  Vec3 v;
  numbers.fill(m);
  numbers.fill(small);
  numbers.fill(v);
  const Mat3 square = m * m.transpose();
  hash.add({m.sum(), m.norm(), m.cwiseAbs().sum(), (m - square).squaredNorm(), m.trace()});
  hash.add({small.sum(), small.norm(), small.inverse()(0, 1)});
  hash.add({v.norm(), v.dot(m * v), (m * v).sum(), m.determinant(), m.inverse()(1, 2)});
}

}  // namespace

int main() {
  Numbers numbers;
  Hash hash;
  for (int i = 0; i < 100'000; ++i) {
    add_quaternions(numbers, hash);
    add_matrices(numbers, hash);
  }
  std::printf("%016llx\n", static_cast<unsigned long long>(hash.value()));
}
