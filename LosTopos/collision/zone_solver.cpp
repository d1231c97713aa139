#include "LosTopos/collision/zone_solver.h"

#include <Eigen/Cholesky>
#include <Eigen/CholmodSupport>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <vector>

#include "LosTopos/collision/impulses.h"

namespace lostopos {
namespace {

constexpr Eigen::Index largest_dense = 12;
constexpr double regularisation = 1e-7;

using Matrix = Eigen::SparseMatrix<double>;
using Terms = std::vector<Eigen::Triplet<double>>;

// One contact's part in a free vertex.
struct Share {
  Vertex vertex;
  int contact;
  int column;  // of the vertex's x in the rows of all contacts
  Vec3 row;    // weight · normal
};

// Sorted by vertex; numbers their columns.
std::vector<Share> shares_by_vertex(const Motion& motion, std::span<const Contact> contacts) {
  std::vector<Share> shares;
  shares.reserve(4 * contacts.size());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Vertex v = contacts[k].pair.vertices[i];
      if (motion.held(v)) continue;
      shares.push_back(
          {v, static_cast<int>(k), 0, contacts[k].weights[i] * free_part(motion.hold(v), contacts[k].normal)});
    }
  }
  std::ranges::stable_sort(shares, {}, &Share::vertex);
  for (std::size_t i = 1; i < shares.size(); ++i) {
    shares[i].column = shares[i - 1].column + (shares[i].vertex == shares[i - 1].vertex ? 0 : 3);
  }
  return shares;
}

// C M^-1/2, so that the masses are one from here on.
Matrix rows_of(const Motion& motion, std::span<const Share> shares, Eigen::Index contact_count) {
  Terms terms;
  terms.reserve(3 * shares.size());
  for (const Share& share : shares) {
    const Vec3 row = std::sqrt(motion.inverse_mass(share.vertex)) * share.row;
    for (int i = 0; i < 3; ++i) terms.emplace_back(share.contact, share.column + i, row[i]);
  }
  Matrix rows(contact_count, shares.back().column + 3);
  rows.setFromTriplets(terms.begin(), terms.end());
  return rows;
}

// Of a symmetric positive definite matrix plus shift times the identity.
class Factors {
 public:
  Factors(Matrix matrix, double shift) {
    Matrix identity(matrix.rows(), matrix.rows());
    identity.setIdentity();
    matrix += shift * identity;
    is_dense_ = matrix.rows() <= largest_dense;
    if (is_dense_) {
      dense_.compute(Eigen::MatrixXd(matrix));
    } else {
      sparse_.cholmod().print = 0;
      sparse_.compute(matrix);
    }
  }
  bool good() const { return (is_dense_ ? dense_.info() : sparse_.info()) == Eigen::Success; }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    if (is_dense_) return dense_.solve(b);
    return sparse_.solve(b);
  }

 private:
  bool is_dense_;
  Eigen::LDLT<Eigen::MatrixXd> dense_;
  // Simplicial: no BLAS, and so the same bits for any number of threads.
  Eigen::CholmodSimplicialLDLT<Matrix, Eigen::Lower> sparse_;
};

double largest_diagonal(const Matrix& rows) {
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(rows.rows());
  for (int column = 0; column < rows.cols(); ++column) {
    for (Matrix::InnerIterator it(rows, column); it; ++it) squares[it.row()] += it.value() * it.value();
  }
  return squares.maxCoeff();
}

// The change of the coordinates, times the roots of their masses; empty when it cannot be solved.
Eigen::VectorXd least_change(const Matrix& rows, const Eigen::VectorXd& b) {
  const double shift = regularisation * largest_diagonal(rows);
  const Matrix transposed = rows.transpose();
  Eigen::VectorXd change;
  if (rows.rows() <= rows.cols()) {
    const Factors factors(rows * transposed, shift);
    if (factors.good()) change = transposed * factors.solve(b);
  } else {
    const Factors factors(transposed * rows, shift);
    if (factors.good()) change = factors.solve(transposed * b);
    // Rounding has moved what no contact holds, by its error over the shift: once more, with that part of the residual
    // free of cancellation, so that the momentum is kept.
    if (factors.good()) change += factors.solve(transposed * (b - rows * change) - shift * change);
  }
  return change.allFinite() ? change : Eigen::VectorXd();
}

}  // namespace

bool solve_contacts(Motion& motion, std::span<const Contact> contacts) {
  const std::vector<Share> shares = shares_by_vertex(motion, contacts);
  if (shares.empty()) return false;
  Eigen::VectorXd b(static_cast<Eigen::Index>(contacts.size()));
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    b[static_cast<Eigen::Index>(k)] = contacts[k].target - relative_displacement(motion, contacts[k]);
  }
  const Eigen::VectorXd change = least_change(rows_of(motion, shares, b.size()), b);
  if (change.size() == 0) return false;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (i > 0 && shares[i].vertex == shares[i - 1].vertex) continue;
    const Vertex v = shares[i].vertex;
    motion.set_end(v,
                   motion.ends()[v.index()] + std::sqrt(motion.inverse_mass(v)) * change.segment<3>(shares[i].column));
  }
  return true;
}

}  // namespace lostopos
