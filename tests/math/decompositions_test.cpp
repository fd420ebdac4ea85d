// SPDX-License-Identifier: BSD-3-Clause
// Decompositions of small matrices against their definitions, and matrices whose rank is known.
#include <fstiff/math/decompositions.hpp>

#include "support/catch.hpp"

#include <cmath>
#include <limits>
#include <random>

namespace decompositions_test {

using namespace fstiff;

namespace {

template <class T>
using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

template <class T>
Matrix<T> random_matrix(Eigen::Index rows, Eigen::Index columns, std::mt19937& generator) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    return Matrix<T>::NullaryExpr(rows, columns, [&] { return static_cast<T>(uniform(generator)); });
}

// |a - b|, and a b, by loops: Eigen's product of large matrices takes long to compile.
template <class T>
T distance(const Matrix<T>& a, const Matrix<T>& b) {
    return (a - b).norm();
}
template <class T>
Matrix<T> product(const Matrix<T>& a, const Matrix<T>& b) {
    return a.lazyProduct(b);
}
template <class T>
Matrix<T> transposed(const Matrix<T>& a) {
    return a.transpose();
}
template <class T>
T from_orthonormal(const Matrix<T>& v) {
    return distance<T>(product<T>(transposed(v), v), Matrix<T>::Identity(v.cols(), v.cols()));
}

// Error of a decomposition of n columns, in units of the rounding.
template <class T>
bool is_rounding(T error) {
    return error <= 60 * std::numeric_limits<T>::epsilon();
}

}  // namespace

TEMPLATE_TEST_CASE("the residual of a least-squares solution is normal to the columns", "[decompositions]",
                   FSTIFF_SCALARS) {
    using T = TestType;
    std::mt19937 generator(1);
    for (const Eigen::Index columns : {1, 2, 5, 10})
        for (const Eigen::Index rows : {columns, columns + 1, 4 * columns, Eigen::Index(60)}) {
            const Matrix<T> a = random_matrix<T>(rows, columns, generator);
            const Matrix<T> b = random_matrix<T>(rows, 1, generator);
            const math::PivotedQr<T> qr(a);
            REQUIRE(qr.rank() == columns);
            const Matrix<T> x = qr.solve(b), left = product<T>(a, x) - b, solver = qr.solver();
            const T size = a.norm() * (a.norm() * x.norm() + b.norm());
            CHECK(is_rounding(product<T>(transposed(a), left).norm() / size));
            CHECK(is_rounding(distance<T>(product(solver, b), x) / (solver.norm() * b.norm())));
        }
}

TEST_CASE("columns that are combinations of others are found, and left out", "[decompositions]") {
    Matrix<double> a(4, 3);
    a << 1, 0, 1, 1, 1, 2, 1, 2, 3, 1, 3, 4;
    const math::PivotedQr<double> qr(a);
    CHECK(qr.rank() == 2);
    const Matrix<double> b = product<double>(a, Eigen::Vector3d(1, 2, 5)), x = qr.solve(b);
    CHECK(distance(product(a, x), b) < 1e-14 * b.norm());
    CHECK((x.array() == 0).count() == 1);
    CHECK(math::PivotedQr<double>(Matrix<double>::Zero(3, 2)).rank() == 0);
    // the threshold counts: a column that differs from another in the ninth digit
    a.col(2) = a.col(0);
    a(3, 2) += 1e-9;
    CHECK(math::PivotedQr<double>(a).rank() == 3);
    CHECK(math::PivotedQr<double>(a, 1e-8).rank() == 2);
}

TEMPLATE_TEST_CASE("singular values are the lengths along their directions", "[decompositions]", FSTIFF_SCALARS) {
    using T = TestType;
    std::mt19937 generator(2);
    for (const Eigen::Index columns : {1, 2, 4, 6}) {
        Matrix<T> a = random_matrix<T>(3 * columns, columns, generator);
        a.col(columns - 1) *= T(1e-3);
        const auto [values, vectors] = math::singular_vectors<T>(a);
        CHECK(is_rounding(from_orthonormal<T>(vectors)));
        const Matrix<T> images = product<T>(a, vectors), products = product<T>(transposed(images), images);
        CHECK(is_rounding((products - Matrix<T>(products.diagonal().asDiagonal())).norm() / products.norm()));
        for (Eigen::Index k = 0; k < columns; ++k) {
            CHECK(is_rounding(std::abs(images.col(k).norm() - values[k]) / values[0]));
            if (k > 0) CHECK(values[k - 1] >= values[k]);
        }
    }
}

TEST_CASE("a direction that a matrix does not see has the singular value 0", "[decompositions]") {
    Matrix<double> a(3, 2);
    a << 1, 2, 2, 4, 3, 6;
    const auto [values, vectors] = math::singular_vectors<double>(a);
    CHECK(values[1] < 1e-15 * values[0]);
    CHECK(std::abs(vectors(0, 1) + 2 * vectors(1, 1)) < 1e-15);
}

TEMPLATE_TEST_CASE("eigenvectors and eigenvalues give the symmetric matrix back", "[decompositions]", FSTIFF_SCALARS) {
    using T = TestType;
    std::mt19937 generator(3);
    for (const Eigen::Index size : {1, 2, 3, 6}) {
        const Matrix<T> half = random_matrix<T>(size, size, generator), a = half + half.transpose();
        const auto [values, vectors] = math::symmetric_eigen<T>(a);
        const Matrix<T> scaled = vectors * values.asDiagonal();
        CHECK(is_rounding(distance<T>(product<T>(scaled, transposed<T>(vectors)), a) / a.norm()));
        CHECK(is_rounding(from_orthonormal<T>(vectors)));
    }
    // exactly: two values that go together
    Matrix<T> pair = Matrix<T>::Ones(2, 2);
    const auto [values, vectors] = math::symmetric_eigen<T>(pair);
    CHECK(values.minCoeff() == T(0));
    CHECK(values.maxCoeff() == T(2));
}

TEMPLATE_TEST_CASE("vectors by loops hold what the expressions of Eigen do", "[decompositions]", FSTIFF_SCALARS) {
    using T = TestType;
    using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;
    std::mt19937 generator(4);
    for (const Eigen::Index size : {1, 2, 5, 8, 33}) {
        const Matrix<T> a = random_matrix<T>(size + 1, size, generator), b = random_matrix<T>(size, 2, generator);
        const Vector x = b.col(0), y = b.col(1);
        CHECK(math::dot_in_lanes(x.data(), y.data(), size) == x.dot(y));  // to the last digit
        CHECK(math::sum_in_lanes(x.data(), size) == x.sum());
        CHECK(math::vector_of<T>(size, [&](Eigen::Index i) { return x[i] - y[i]; }) == Vector(x - y));
        CHECK(is_rounding((math::product(a, x.data(), size) - a.lazyProduct(x)).norm()));
        const Vector fewer = math::product(a, x.data(), size - 1) - a.leftCols(size - 1).lazyProduct(x.head(size - 1));
        CHECK(is_rounding(fewer.norm()));
        Vector cubes(size);
        math::raise(x.data(), T(3), cubes.data(), size);
        CHECK(is_rounding((cubes - x.cwiseProduct(x).cwiseProduct(x)).norm()));
    }
}

}  // namespace decompositions_test
