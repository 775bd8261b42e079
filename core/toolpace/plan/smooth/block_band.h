#pragma once
/// Symmetric positive definite system of blocks, each coupled to the three before it, solved in linear time.

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace toolpace::detail::tube {

template <int B>
class BlockBand {
 public:
  using Block = Eigen::Matrix<double, B, B>;
  using Vector = Eigen::Matrix<double, B, 1>;
  static constexpr std::size_t kReach = 3;

  void reset(std::size_t n) {
    n_ = n;
    blocks_.assign(n * (kReach + 1), Block::Zero());
    rhs_.assign(n, Vector::Zero());
  }
  /// Block in row k, column k − back.
  Block& at(std::size_t k, std::size_t back) { return blocks_[k * (kReach + 1) + back]; }
  Vector& right(std::size_t k) { return rhs_[k]; }
  const std::vector<Vector>& solution() const { return rhs_; }

  /// Cholesky factorisation and both substitutions; the solution replaces the right side.
  /// @return false where the matrix is not positive definite
  bool solve() {
    for (std::size_t k = 0; k < n_; ++k) {
      if (!factor_row(k)) return false;
    }
    for (std::size_t k = n_; k-- > 0;) {
      for (std::size_t ahead = 1; ahead <= kReach && k + ahead < n_; ++ahead) {
        rhs_[k].noalias() -= at(k + ahead, ahead).transpose() * rhs_[k + ahead];
      }
      const Block& l = at(k, 0);
      for (int i = B - 1; i >= 0; --i) {
        double s = rhs_[k][i];
        for (int j = i + 1; j < B; ++j) s -= l(j, i) * rhs_[k][j];
        rhs_[k][i] = s * l(i, i);
      }
    }
    return true;
  }

 private:
  /// The diagonal of a factored block holds reciprocals.
  bool factor_row(std::size_t k) {
    const std::size_t first = k >= kReach ? k - kReach : 0;
    for (std::size_t l = first; l < k; ++l) {
      Block& a = at(k, k - l);
      for (std::size_t m = l >= kReach && l - kReach > first ? l - kReach : first; m < l; ++m) {
        a.noalias() -= at(k, k - m) * at(l, l - m).transpose();
      }
      solve_right(a, at(l, 0));
    }
    Block& d = at(k, 0);
    for (std::size_t m = first; m < k; ++m) {
      d.noalias() -= at(k, k - m) * at(k, k - m).transpose();
      rhs_[k].noalias() -= at(k, k - m) * rhs_[m];
    }
    if (!cholesky(d)) return false;
    for (int i = 0; i < B; ++i) {
      double s = rhs_[k][i];
      for (int j = 0; j < i; ++j) s -= d(i, j) * rhs_[k][j];
      rhs_[k][i] = s * d(i, i);
    }
    return true;
  }
  /// a ← a·l⁻ᵀ
  static void solve_right(Block& a, const Block& l) {
    for (int c = 0; c < B; ++c) {
      for (int j = 0; j < c; ++j) a.col(c) -= a.col(j) * l(c, j);
      a.col(c) *= l(c, c);
    }
  }
  static bool cholesky(Block& d) {
    for (int i = 0; i < B; ++i) {
      for (int j = 0; j < i; ++j) {
        double s = d(i, j);
        for (int q = 0; q < j; ++q) s -= d(i, q) * d(j, q);
        d(i, j) = s * d(j, j);
      }
      double s = d(i, i);
      for (int q = 0; q < i; ++q) s -= d(i, q) * d(i, q);
      if (!(s > 0)) return false;
      d(i, i) = 1 / std::sqrt(s);
    }
    return true;
  }

  std::size_t n_ = 0;
  std::vector<Block> blocks_;
  std::vector<Vector> rhs_;
};

}  // namespace toolpace::detail::tube
