#include <cmath>

#include "strandyn/math/chain_matrix.hpp"
#include "wide_blocks.hpp"

namespace strandyn::math {
namespace {

/// What a BlockTridiagonalLU keeps, which it shows to whoever archives it.
template <class F>
struct Kept {
  const F& f;
  template <class Blocks>
  void operator()(Blocks& inverse, Blocks& lower, Blocks& upper) const {
    f(inverse, lower, upper);
  }
};

/// The sums of BlockTridiagonalLU::factorize and solve; those of blocks of five and six in wide registers.
template <int B>
bool factorize_blocks(const BlockTridiagonal<B>& a, BlockTridiagonalLU<B>& factors) {
  if constexpr (B < 5) {
    return factors.factorize(a);
  } else {
    const std::size_t n = a.nodes();
    bool done = true;
    const auto eliminate = [&](auto& inverse, auto& lower, auto& upper) {
      using Block = typename BlockTridiagonal<B>::Block;
      for (auto* blocks : {&inverse, &lower, &upper}) blocks->resize(n, Block::Zero());
      for (std::size_t i = 0; i + 1 < n; ++i) upper[i] = a.upper(i);
      const double* below = n > 1 ? a.lower(0).data() : nullptr;
      done = n == 0 || wide_blocks::eliminate<B>({n, a.diagonal(0).data(), upper[0].data(), below}, inverse[0].data(),
                                                 lower[0].data());
    };
    Kept<decltype(eliminate)> kept{eliminate};
    factors.archive(kept);
    return done;
  }
}

template <int B>
void solve_blocks(const BlockTridiagonalLU<B>& factors, double* x) {
  if constexpr (B < 5) {
    factors.solve(x);
  } else {
    const auto substitute = [x](const auto& inverse, const auto& lower, const auto& upper) {
      if (inverse.empty()) return;
      wide_blocks::substitute<B>(inverse.size(), inverse[0].data(), lower[0].data(), upper[0].data(), x);
    };
    Kept<decltype(substitute)> kept{substitute};
    const_cast<BlockTridiagonalLU<B>&>(factors).archive(kept);  // which only looks
  }
}

}  // namespace

bool ChainFactors::factorize(const ChainMatrix& a) {
  const bool done = with_block_size(a.block(), [&](auto B) {
    using Factors = BlockTridiagonalLU<B()>;
    if (!std::holds_alternative<Factors>(factors_)) factors_ = Factors();
    return factorize_blocks<B()>(a.as<B()>(), std::get<Factors>(factors_));
  });
  updated_ = a.update().has_value();
  if (!done || !updated_) return done;
  row_ = a.update()->row;
  solved_column_ = a.update()->column;
  std::visit([&](const auto& f) { solve_blocks(f, solved_column_.data()); }, factors_);
  const double pivot = 1 + row_.dot(solved_column_);
  solved_column_ /= pivot;
  return std::isfinite(pivot) && pivot != 0;
}

void ChainFactors::solve(double* x) const {
  std::visit([&](const auto& f) { solve_blocks(f, x); }, factors_);
  if (!updated_) return;
  Eigen::Map<Eigen::VectorXd> solution(x, row_.size());
  solution -= solved_column_ * row_.dot(solution);
}

bool ChainFactors::fit(const ChainMatrix& a) const {
  const auto size = static_cast<Eigen::Index>(a.size());
  return factors_.index() + 2 == static_cast<std::size_t>(a.block()) &&
         std::visit([&](const auto& f) { return f.fit(a.nodes()); }, factors_) &&
         (!updated_ || (row_.size() == size && solved_column_.size() == size));
}

}  // namespace strandyn::math
