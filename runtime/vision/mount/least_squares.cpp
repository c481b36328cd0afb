#include "vision/mount/least_squares.h"

#include <cmath>

#include <Eigen/Cholesky>

namespace mirada::vision {
namespace {

Eigen::MatrixXd slopes(const Residuals& residuals, const Eigen::VectorXd& x, const Eigen::VectorXd& step,
                       Eigen::Index rows) {
  Eigen::MatrixXd J(rows, x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Eigen::VectorXd up = x;
    Eigen::VectorXd down = x;
    up[i] += step[i];
    down[i] -= step[i];
    const Eigen::VectorXd high = residuals(up);
    const Eigen::VectorXd low = residuals(down);
    if (high.size() != rows || low.size() != rows) return {};
    J.col(i) = (high - low) / (2 * step[i]);
  }
  return J;
}

}  // namespace

LeastSquares minimise(const Residuals& residuals, Eigen::VectorXd start, const Eigen::VectorXd& step) {
  LeastSquares out;
  out.x = std::move(start);
  Eigen::VectorXd r = residuals(out.x);
  if (r.size() == 0) return out;
  double damping = 1e-3;
  for (int i = 0; i < 100; ++i) {
    const Eigen::MatrixXd J = slopes(residuals, out.x, step, r.size());
    if (J.size() == 0) return out;
    out.information = J.transpose() * J;
    Eigen::MatrixXd damped = out.information;
    damped.diagonal() *= 1 + damping;
    const Eigen::VectorXd dx = damped.ldlt().solve(-J.transpose() * r);
    const Eigen::VectorXd next = residuals(out.x + dx);
    if (next.size() == r.size() && next.squaredNorm() <= r.squaredNorm()) {
      const bool still = (dx.array().abs() < step.array() * 1e-3).all();
      out.x += dx;
      r = next;
      damping = std::max(damping / 10, 1e-12);
      out.converged = still;
      if (still) break;
    } else {
      damping *= 10;
      // No way down any more: as good as the arithmetic allows.
      out.converged = damping > 1e9;
      if (out.converged) break;
    }
  }
  out.rms = std::sqrt(r.squaredNorm() / static_cast<double>(r.size()));
  return out;
}

}  // namespace mirada::vision
