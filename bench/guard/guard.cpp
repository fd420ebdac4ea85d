// SPDX-License-Identifier: BSD-3-Clause
// Holds costs and errors against bench/baseline.csv, without a clock: the same on a busy machine as on a quiet one.
//
//     fstiff_guard bench/baseline.csv            exit code 1, and a sentence for each row that got worse
//     fstiff_guard bench/baseline.csv --renew    writes the file anew
//
// A row holds the evaluations of the integrand summed over its problems (may not rise by more than 0.2 %, which leaves
// room for a node at the very end of a window that another rounding lets in), the largest relative error (may not
// exceed four times the baseline plus 4 ulp: rounding differs between processors and compilers), the values that are
// further from the truth than their error estimate, and the heap allocations of all calls (neither may rise).
#include "support/allocations.hpp"

#include <fstiff/double/contacts.hpp>

#include "../methods.hpp"

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>

namespace {

using namespace bench;

struct Row {
    std::string name;
    double evaluations, error;
    long beyond_estimate, allocations;
};

template <class Call>
long allocations_of(const Call& call) {
    call();  // once for what is kept: tables, references
    const long before = test::allocations();
    call();
    return test::allocations() - before;
}

template <class Method>
Row integrals_row(const std::string& name, const std::vector<Problem>& set, const Which& which, const Method& method) {
    const Accuracy found = accuracy(set, which, method);
    const long allocations = allocations_of([&] {
        for (const Problem& problem : set) static_cast<void>(method(problem));
    });
    return {name, std::round(found.evaluations * static_cast<double>(set.size())), found.largest, found.beyond_estimate,
            allocations};
}

/// \p call(point) returns {value, truth, evaluations}.
struct Checked {
    double value, truth, evaluations;
};
template <class Call>
Row law_row(const std::string& name, const Call& call) {
    AccuracyCollector collector;
    double evaluations = 0;
    for (const LawPoint& point : law_points()) {
        const Checked at = call(point);
        collector.add(at.value, at.truth);
        evaluations += at.evaluations;
    }
    const long allocations = allocations_of([&] {
        for (const LawPoint& point : law_points()) static_cast<void>(call(point));
    });
    return {name, evaluations, collector.accuracy().largest, 0, allocations};
}

std::vector<Row> integrals() {
    std::vector<Row> out;
    for (const char* grid : {plain, hard})
        for (const double tolerance : tolerances) {
            const auto add = [&](const char* what, const Which& which, auto method) {
                out.push_back(
                    integrals_row(std::string("integrals/fstiff/") + what + "/" + grid + "/" + text_of(tolerance),
                                  problems(grid), which, [&](const Problem& p) { return method(p, tolerance); }));
            };
            add("four", four, reduced<Quantity::all>);
            add("stiffness_load", two, reduced<Quantity::stiffness | Quantity::pressure>);
            add("stiffness", one, reduced<Quantity::stiffness>);
        }
    for (const double tolerance : {1e-3, 1e-12})
        out.push_back(integrals_row("integrals/fstiff-tensor/four/plain/" + text_of(tolerance), problems(plain), four,
                                    [&](const Problem& p) { return tensor(p, four, tolerance); }));
    out.push_back(integrals_row("integrals/fstiff-paper/stiffness/plain/50x50", problems(plain), one,
                                [](const Problem& p) { return paper(p, one); }));
    out.push_back(integrals_row("kernel/gradual_yield/1e-12", law_problems<GradualYield>(), load, [](const Problem& p) {
        return kernel<fstiff::NodeClustering::even, GradualYield>(p, 1e-12);
    }));
    for (const double tolerance : {1e-3, 1e-9})
        out.push_back(integrals_row(
            "kernel/elastic_plastic/" + text_of(tolerance), law_problems<ElasticPlastic>(), load,
            [&](const Problem& p) { return kernel<fstiff::NodeClustering::graded, ElasticPlastic>(p, tolerance); }));
    out.push_back(
        integrals_row("kernel/elastic_plastic_untold/1e-03", law_problems<ElasticPlastic>(), load,
                      [](const Problem& p) { return kernel<fstiff::NodeClustering::rough, ElasticPlastic>(p, 1e-3); }));
    return out;
}

std::vector<Row> laws() {
    std::vector<Row> out;
    const auto contact = sand_blasted_contact();
    out.push_back(law_row("contact/at_pressure/all", [&](const LawPoint& p) -> Checked {
        const auto at = contact.at_pressure(p.pressure);
        return {at.stiffness.value, p.stiffness, static_cast<double>(at.stiffness.evaluations)};
    }));
    out.push_back(law_row("contact/at_separation/all", [&](const LawPoint& p) -> Checked {
        const auto at = contact.at_separation(p.separation);
        return {at.stiffness.value, p.stiffness, static_cast<double>(at.stiffness.evaluations)};
    }));

    const auto law = tabulated_law();
    out.push_back(law_row("law/stiffness_of_pressure/scalar", [&](const LawPoint& p) {
        return Checked{law.stiffness(p.pressure), p.stiffness, 0};
    }));
    out.push_back(law_row("law/pressure_and_stiffness_of_gap/scalar", [&](const LawPoint& p) {
        const auto at = law.at_separation(p.separation);
        const bool load_is_worse =
            test::relative_error(at.pressure, p.pressure) > test::relative_error(at.stiffness, p.stiffness);
        return load_is_worse ? Checked{at.pressure, p.pressure, 0} : Checked{at.stiffness, p.stiffness, 0};
    }));
    Eigen::ArrayXd in(static_cast<Eigen::Index>(law_points().size())), separations = in, pressures = in,
                                                                       stiffnesses = in;
    for (Eigen::Index i = 0; i < in.size(); ++i) {
        in[i] = law_points()[static_cast<std::size_t>(i)].pressure;
        separations[i] = law_points()[static_cast<std::size_t>(i)].separation;
    }
    law.stiffness(in, stiffnesses);
    Row batch = law_row("law/stiffness_of_pressure/batch", [&](const LawPoint& p) {
        return Checked{stiffnesses[&p - law_points().data()], p.stiffness, 0};
    });
    batch.allocations = allocations_of([&] { law.stiffness(in, stiffnesses); });
    out.push_back(batch);
    law.at_separation(separations, pressures, stiffnesses);
    batch = law_row("law/pressure_and_stiffness_of_gap/batch", [&](const LawPoint& p) {
        return Checked{stiffnesses[&p - law_points().data()], p.stiffness, 0};
    });
    batch.allocations = allocations_of([&] { law.at_separation(separations, pressures, stiffnesses); });
    out.push_back(batch);
    out.push_back({"law/compile", static_cast<double>(law.evaluations()), law.relative_error(), 0,
                   allocations_of([] { static_cast<void>(tabulated_law()); })});
    return out;
}

constexpr const char* header = "row,evaluations,rel_err_max,beyond_estimate,allocations";

int renew(const std::string& path, const std::vector<Row>& rows) {
    std::ofstream file(path);
    file << header << '\n';
    for (const Row& row : rows) {
        char line[200];
        std::snprintf(line, sizeof line, "%s,%.0f,%.2e,%ld,%ld\n", row.name.c_str(), row.evaluations, row.error,
                      row.beyond_estimate, row.allocations);
        file << line;
    }
    file.close();
    if (file) return 0;
    std::cerr << "cannot write " << path << '\n';
    return 2;
}

/// The rows of \p path. \throws std::runtime_error for a file that --renew did not write.
std::map<std::string, Row> read(const std::string& path) {
    std::ifstream file(path);
    std::string line;
    if (!file || !std::getline(file, line) || line != header)
        throw std::runtime_error(path + " is not a baseline: its first line must be " + header);
    std::map<std::string, Row> out;
    while (std::getline(file, line)) {
        Row row;
        char comma = 0;
        std::istringstream cells(line);
        std::getline(cells, row.name, ',');
        if (!(cells >> row.evaluations >> comma >> row.error >> comma >> row.beyond_estimate >> comma >>
              row.allocations))
            throw std::runtime_error(path + ": cannot read the row " + line);
        out[row.name] = row;
    }
    return out;
}

int compare(const std::vector<Row>& rows, std::map<std::string, Row> baseline) {
    int failures = 0;
    const auto fail = [&](const std::string& name, const std::string& what) {
        std::cout << name << ": " << what << '\n';
        ++failures;
    };
    const auto number = [](double x) {
        std::ostringstream text;
        text.precision(std::abs(x) < 1 ? 3 : 10);
        text << x;
        return text.str();
    };
    int better = 0;
    for (const Row& now : rows) {
        const auto found = baseline.find(now.name);
        if (found == baseline.end()) {
            fail(now.name, "is not in the baseline; add it with --renew");
            continue;
        }
        const Row& then = found->second;
        if (now.evaluations > then.evaluations * 1.002)
            fail(now.name, number(now.evaluations) + " evaluations of the integrand, the baseline has " +
                               number(then.evaluations));
        if (!(now.error <= 4 * then.error + 4 * std::numeric_limits<double>::epsilon()))
            fail(now.name, "largest relative error " + number(now.error) + ", more than four times the " +
                               number(then.error) + " of the baseline");
        if (now.beyond_estimate > then.beyond_estimate)
            fail(now.name, number(static_cast<double>(now.beyond_estimate)) +
                               " values beyond their error estimate, the baseline has " +
                               number(static_cast<double>(then.beyond_estimate)));
        if (now.allocations > then.allocations)
            fail(now.name, number(static_cast<double>(now.allocations)) + " heap allocations, the baseline has " +
                               number(static_cast<double>(then.allocations)));
        if (now.evaluations < 0.98 * then.evaluations || now.error < then.error / 10 ||
            now.allocations < then.allocations)
            ++better;
        baseline.erase(found);
    }
    for (const auto& [name, row] : baseline)
        fail(name, "is in the baseline and is not computed any more; renew the baseline if that is intended");
    if (failures == 0 && better > 0)
        std::cout << better << " rows are better than the baseline: hold the gain with --renew\n";
    std::cout << rows.size() << " rows, " << failures << " complaints\n";
    return failures == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
    const bool renewing = argc == 3 && std::strcmp(argv[2], "--renew") == 0;
    if (argc != 2 && !renewing) {
        std::cerr << "usage: fstiff_guard bench/baseline.csv [--renew]\n";
        return 2;
    }
    std::vector<Row> rows = integrals();
    for (Row& row : laws()) rows.push_back(std::move(row));
    return renewing ? renew(argv[1], rows) : compare(rows, read(argv[1]));
} catch (const std::exception& error) {
    std::cerr << "fstiff_guard: " << error.what() << '\n';
    return 2;
}
