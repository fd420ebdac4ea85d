// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Vectors and decompositions of small matrices in plain loops, which compile in a fraction of the time of Eigen's:
/// there each expression is a type of its own.
///
///     PivotedQr        A P = Q R by Householder's reflections, the longest column left first      linear least squares
///     singular_vectors     A V = U S by rotations of pairs of columns (Hestenes)             directions A does not see
///     symmetric_eigen      A = V L V^T by rotations of rows and columns (Jacobi)                 roots of correlations
///
/// Reference   Golub, Van Loan, Matrix Computations, 4th ed. (2013), algorithms 5.4.1, 8.5.3, section 8.6.3
/// Units       those of the caller
/// Valid       finite elements, squares within the range of numbers; PivotedQr, singular_vectors: rows >= columns
/// Accuracy    backward stable: for well-conditioned matrices a few ulp per row (tests/math/decompositions_test.cpp)

#include <fstiff/core/numbers.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace math {

template <Real T>
T dot(const T* a, const T* b, Eigen::Index count) {
    T sum = 0;
    for (Eigen::Index i = 0; i < count; ++i) sum += a[i] * b[i];
    return sum;
}

/// The same, and the sum of \p count numbers, in the lanes of Eigen: faster, and rounded in the order of its sum().
template <Real T>
T dot_in_lanes(const T* a, const T* b, Eigen::Index count) {
    using Numbers = Eigen::Map<const Eigen::Array<T, Eigen::Dynamic, 1>>;
    return (Numbers(a, count) * Numbers(b, count)).sum();
}
template <Real T>
T sum_in_lanes(const T* a, Eigen::Index count) {
    return Eigen::Map<const Eigen::Array<T, Eigen::Dynamic, 1>>(a, count).sum();
}

/// The vector of \p size elements \p number(i).
template <Real T, class Number>
Eigen::Matrix<T, Eigen::Dynamic, 1> vector_of(Eigen::Index size, const Number& number) {
    Eigen::Matrix<T, Eigen::Dynamic, 1> result(size);
    for (Eigen::Index i = 0; i < size; ++i) result[i] = number(i);
    return result;
}

/// Writes the powers of \p count numbers \p x to \p to.
template <Real T>
void raise(const T* x, T exponent, T* to, Eigen::Index count) {
    using Numbers = Eigen::Array<T, Eigen::Dynamic, 1>;
    Eigen::Map<Numbers>(to, count) = Eigen::Map<const Numbers>(x, count).pow(exponent);
}

/// The first \p columns of \p a times \p x, the terms of each sum in their order.
template <Real T>
Eigen::Matrix<T, Eigen::Dynamic, 1> product(const Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>& a, const T* x,
                                            Eigen::Index columns) {
    using Numbers = Eigen::Array<T, Eigen::Dynamic, 1>;
    Eigen::Matrix<T, Eigen::Dynamic, 1> result(a.rows());
    std::fill_n(result.data(), a.rows(), T(0));
    Eigen::Map<Numbers> sums(result.data(), a.rows());
    for (Eigen::Index k = 0; k < columns; ++k) sums += Eigen::Map<const Numbers>(&a(0, k), a.rows()) * x[k];
    return result;
}

/// The rotation by the smaller angle that makes [p c; c q] diagonal.
template <Real T>
struct Rotation {
    T cosine, sine, tangent;
    Rotation(T p, T c, T q) {
        const T half = (q - p) / (2 * c);
        tangent = std::copysign(T(1), half) / (std::abs(half) + std::hypot(T(1), half));
        cosine = 1 / std::sqrt(1 + tangent * tangent);
        sine = cosine * tangent;
    }
    void operator()(T& a, T& b) const {
        const T before = a;
        a = cosine * before - sine * b;
        b = sine * before + cosine * b;
    }
};

/// Sweeps over all pairs end here at the latest; they converge quadratically, in six to ten.
inline constexpr int max_sweeps = 60;

/// A least-squares solver for a matrix of at least as many rows as columns.
template <Real T = double>
class PivotedQr {
public:
    using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;
    using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
    using Index = Eigen::Index;

    /// A column whose rest, without the columns chosen before, is less than \p threshold times the longest column, is
    /// taken for a combination of those.
    explicit PivotedQr(Matrix a, T threshold = 16 * std::numeric_limits<T>::epsilon())
        : qr_(std::move(a)), diagonal_(static_cast<std::size_t>(qr_.cols())), order_(diagonal_.size()) {
        const Index rows = qr_.rows(), columns = qr_.cols();
        for (Index k = 0; k < columns; ++k) order_[static_cast<std::size_t>(k)] = k;
        T longest = 0;
        for (Index k = 0; k < columns && k < rows; ++k) {
            const Index left = rows - k;
            Index pivot = k;
            T square = -1;
            for (Index j = k; j < columns; ++j) {
                const T norm = dot(&qr_(k, j), &qr_(k, j), left);
                if (norm > square) square = norm, pivot = j;
            }
            const T length = std::sqrt(square);
            if (k == 0) longest = length;
            if (!(length > threshold * longest)) break;
            if (pivot != k) {
                for (Index i = 0; i < rows; ++i) std::swap(qr_(i, k), qr_(i, pivot));
                std::swap(order_[static_cast<std::size_t>(k)], order_[static_cast<std::size_t>(pivot)]);
            }
            // the reflection 1 - v v^T / (length v_0): v: the column, its first element moved away from 0
            T* v = &qr_(k, k);
            const T moved = v[0] < 0 ? -length : length;
            v[0] += moved;
            diagonal_[static_cast<std::size_t>(k)] = -moved;
            for (Index j = k + 1; j < columns; ++j) {
                T* other = &qr_(k, j);
                const T share = dot(v, other, left) / (moved * v[0]);
                for (Index i = 0; i < left; ++i) other[i] -= share * v[i];
            }
            rank_ = k + 1;
        }
    }

    [[nodiscard]] Index rank() const { return rank_; }
    /// x that minimises |A x - b|; 0 for the columns beyond the rank.
    [[nodiscard]] Vector solve(Vector b) const {
        solve_in_place(b.data());
        Vector x = Vector::Zero(qr_.cols());
        for (Index k = 0; k < rank_; ++k) x[order_[static_cast<std::size_t>(k)]] = b[k];
        return x;
    }
    /// The matrix that gives x of b, a row for every column of A.
    [[nodiscard]] Matrix solver() const {
        Matrix result = Matrix::Zero(qr_.cols(), qr_.rows());
        Vector unit(qr_.rows());
        for (Index i = 0; i < qr_.rows(); ++i) {
            unit.setZero();
            unit[i] = 1;
            solve_in_place(unit.data());
            for (Index k = 0; k < rank_; ++k) result(order_[static_cast<std::size_t>(k)], i) = unit[k];
        }
        return result;
    }

private:
    /// Overwrites the first rank() elements of \p b by those of R^-1 Q^T b.
    void solve_in_place(T* b) const {
        for (Index k = 0; k < rank_; ++k) {
            const T* v = &qr_(k, k);
            const Index left = qr_.rows() - k;
            const T share =
                dot(v, static_cast<const T*>(b + k), left) / (-diagonal_[static_cast<std::size_t>(k)] * v[0]);
            for (Index i = 0; i < left; ++i) b[k + i] -= share * v[i];
        }
        for (Index k = rank_ - 1; k >= 0; --k) {
            for (Index j = k + 1; j < rank_; ++j) b[k] -= qr_(k, j) * b[j];
            b[k] /= diagonal_[static_cast<std::size_t>(k)];
        }
    }

    Matrix qr_;                ///< R above the diagonal, the reflections below and on it
    std::vector<T> diagonal_;  ///< of R
    std::vector<Index> order_;
    Index rank_ = 0;
};

/// Singular values of a matrix, falling, and the directions that belong to them, one a column.
template <Real T = double>
struct SingularVectors {
    Eigen::Matrix<T, Eigen::Dynamic, 1> values;
    Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> vectors;
};

/// Eigenvalues of a symmetric matrix, in no order, and the eigenvectors, one a column.
template <Real T = double>
struct SymmetricEigen {
    Eigen::Matrix<T, Eigen::Dynamic, 1> values;
    Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> vectors;
};

/// The singular values of \p a, and the vectors on its right.
template <Real T>
[[nodiscard]] SingularVectors<T> singular_vectors(Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> a) {
    using Index = Eigen::Index;
    const Index rows = a.rows(), columns = a.cols();
    SingularVectors<T> result;
    result.values.resize(columns);
    result.vectors.setIdentity(columns, columns);
    auto& v = result.vectors;
    bool turned = true;
    for (int sweep = 0; turned && sweep < max_sweeps; ++sweep) {
        turned = false;
        for (Index i = 0; i + 1 < columns; ++i)
            for (Index j = i + 1; j < columns; ++j) {
                const T ii = dot(&a(0, i), &a(0, i), rows), jj = dot(&a(0, j), &a(0, j), rows);
                const T ij = dot(&a(0, i), &a(0, j), rows);
                if (!(std::abs(ij) > std::numeric_limits<T>::epsilon() * std::sqrt(ii) * std::sqrt(jj))) continue;
                turned = true;
                const math::Rotation<T> rotate(ii, ij, jj);
                for (Index k = 0; k < rows; ++k) rotate(a(k, i), a(k, j));
                for (Index k = 0; k < columns; ++k) rotate(v(k, i), v(k, j));
            }
    }
    for (Index i = 0; i < columns; ++i) result.values[i] = std::sqrt(dot(&a(0, i), &a(0, i), rows));
    for (Index i = 0; i < columns; ++i) {  // the largest first
        Index largest = i;
        for (Index j = i + 1; j < columns; ++j)
            if (result.values[j] > result.values[largest]) largest = j;
        if (largest == i) continue;
        std::swap(result.values[i], result.values[largest]);
        for (Index k = 0; k < columns; ++k) std::swap(v(k, i), v(k, largest));
    }
    return result;
}

/// Eigenvalues and eigenvectors of the symmetric matrix \p a.
template <Real T>
[[nodiscard]] SymmetricEigen<T> symmetric_eigen(Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> a) {
    using Index = Eigen::Index;
    const Index size = a.rows();
    SymmetricEigen<T> result;
    result.values.resize(size);
    result.vectors.setIdentity(size, size);
    T square = 0;
    for (Index j = 0; j < size; ++j) square += dot(&a(0, j), &a(0, j), size);
    const T nothing = std::numeric_limits<T>::epsilon() / 16 * std::sqrt(square);
    bool turned = true;
    for (int sweep = 0; turned && sweep < max_sweeps; ++sweep) {
        turned = false;
        for (Index i = 0; i + 1 < size; ++i)
            for (Index j = i + 1; j < size; ++j) {
                if (!(std::abs(a(i, j)) > nothing)) continue;
                turned = true;
                const math::Rotation<T> rotate(a(i, i), a(i, j), a(j, j));
                const T moved = rotate.tangent * a(i, j);
                for (Index k = 0; k < size; ++k) {
                    if (k != i && k != j) {
                        rotate(a(k, i), a(k, j));
                        a(i, k) = a(k, i), a(j, k) = a(k, j);
                    }
                    rotate(result.vectors(k, i), result.vectors(k, j));
                }
                a(i, i) -= moved, a(j, j) += moved;
                a(i, j) = a(j, i) = 0;
            }
    }
    for (Index i = 0; i < size; ++i) result.values[i] = a(i, i);
    return result;
}

}}}  // namespace fstiff::math
