/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Calls UINTER as Abaqus would, and holds what it returns against the law of fstiff.h and against differences of the
 * stress. Prints a table of the first law; the exit code is the number of checks that failed.
 */
#include <fstiff.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Every argument by address, arrays by columns; behind the last the lengths of the three names, as compilers of Fortran
 * pass. */
#define ARGUMENTS                                                                                                   \
    double *stress, double *ddsddr, double *amki, double *amski, double *flux, double *ddfddt, double *ddsddt,      \
        double *ddfddr, double *statev, double *sed, double *sfd, double *spd, double *svd, double *scd,            \
        double *pnewdt, const double *rdisp, const double *drdisp, const double *temp, const double *dtemp,         \
        const double *predef, const double *dpred, const double *time, const double *dtime, const double *freqr,    \
        const char *ciname, const char *slname, const char *msname, const double *props, const double *coords,      \
        const double *alocaldir, const double *drot, const double *area, const double *chrlngth, const int *node,   \
        const int *ndir, const int *nstatv, const int *npred, const int *nprops, const int *mcrd, const int *kstep, \
        const int *kinc, const int *kit, const int *linper, int *lopenclose, int *lstate, int *lsdi,                \
        const int *lprint, size_t ciname_length, size_t slname_length, size_t msname_length
void uinter(ARGUMENTS);
void uinter_(ARGUMENTS);

static int stops = 0, failures = 0;

/* Of Abaqus, where it ends the analysis. */
void xit_(void);
void xit_(void) { ++stops; }

static void check(int good, const char* what, double value) {
    if (good) return;
    ++failures;
    printf("failed: %s (%.17g)\n", what, value);
}

static double off(double a, double b) { return fabs(a - b) / fabs(b); }

enum { directions = 3, without_friction = 13, property_count = 15, slip_variables = 50 };

/* What one point of the slave face hands on and gets back. */
typedef struct point {
    double stress[3], ddsddr[9], state[slip_variables], energy, loss;
    int ndir, nstatv, nprops, linper;
} point;

static double turn[4] = {1, 0, 0, 1}; /* DROT, by columns */

static point call(void (*entry)(ARGUMENTS), point at, const double* props, const double* rdisp, const double* drdisp) {
    double amki[9] = {1}, amski[9] = {2}, flux[2] = {3, 4}, ddfddt[4] = {5}, ddsddt[6] = {6}, ddfddr[6] = {7};
    double spd = 9, svd = 10, scd = 11, pnewdt = 1e36;
    const double pair[2] = {20, 20}, none[2] = {0, 0}, one = 1, axes[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const int number = 7, zero = 0, three = 3;
    int open = -1, state = -1, discontinuity = 0;
    char name[80];
    memset(name, ' ', sizeof name);
    entry(at.stress, at.ddsddr, amki, amski, flux, ddfddt, ddsddt, ddfddr, at.state, &at.energy, &at.loss, &spd, &svd,
          &scd, &pnewdt, rdisp, drdisp, pair, none, pair, none, pair, &one, &one, name, name, name, props, axes, axes,
          turn, &one, &one, &number, &at.ndir, &at.nstatv, &zero, &at.nprops, &three, &number, &number, &zero,
          &at.linper, &open, &state, &discontinuity, &zero, sizeof name, sizeof name, sizeof name);
    check(amki[0] == 1 && amski[0] == 2 && flux[0] == 3 && flux[1] == 4 && ddfddt[0] == 5 && ddsddt[0] == 6 &&
              ddfddr[0] == 7 && spd == 9 && svd == 10 && scd == 11 && pnewdt == 1e36 && open == -1 && state == -1 &&
              discontinuity == 0,
          "what does not belong to the contact stays as it was", 0);
    return at;
}

static point fresh(void) {
    point at;
    memset(&at, 0, sizeof at);
    for (int i = 0; i < 9; ++i) at.ddsddr[i] = 99;
    at.ndir = directions, at.nstatv = 1, at.nprops = without_friction, at.loss = 8;
    return at;
}

/* The state at one overclosure. */
static point at_overclosure(const double* props, double overclosure) {
    const double rdisp[3] = {overclosure, 0.3, -0.2}, drdisp[3] = {0, 0.3, -0.2};
    return call(uinter_, fresh(), props, rdisp, drdisp);
}

/* The law of the same properties by the C interface, lengths times `length`, pressures times `pressure`. */
static fstiff_law* law_in(const double* props, double length, double pressure) {
    static const char* const names[] = {"hertz", "fractal_consistent", "hybrid", "plastic_peaks"};
    fstiff_face face = {.size = sizeof face,
                        .rms_height = props[1] * length,
                        .peak_radius = props[2] * length,
                        .peak_density = props[3] / length / length,
                        .r = props[4],
                        .theta = props[5],
                        .fractal_dimension = props[6],
                        .rms_gradient = props[7]};
    fstiff_joint joint = {.size = sizeof joint, .face = &face, .effective_modulus = props[8] * pressure};
    joint.upper.hardness = props[9] * pressure;
    fstiff_contact* contact = NULL;
    fstiff_law* law = NULL;
    if (fstiff_contact_make(names[(int)props[0] - 1], &joint, &contact) != FSTIFF_OK ||
        fstiff_law_make(contact, props[10] * pressure, props[11] * pressure, FSTIFF_OUTSIDE_EXTRAPOLATE, &law) !=
            FSTIFF_OK)
        check(0, fstiff_last_message(), props[0]);
    fstiff_contact_free(contact);
    return law;
}

/* From half the least pressure of the table to twice the greatest. */
static void check_law(const double* props, int print) {
    fstiff_law *same = law_in(props, 1, 1), *si = law_in(props, 1e-3, 1e6);
    if (!same || !si) return;
    double light, heavy;
    fstiff_law_at_pressure(same, props[10] / 2, &light, NULL, NULL);
    fstiff_law_at_pressure(same, props[11] * 2, &heavy, NULL, NULL);
    if (print) puts("overclosure [mm]  STRESS(1) [MPa]  DDSDDR(1,1) [MPa/mm]  over its difference - 1");
    enum { steps = 24 };
    for (int i = 0; i <= steps; ++i) {
        const double x = props[12] - light + (light - heavy) * i / steps;
        const point at = at_overclosure(props, x);
        double p, slope;
        fstiff_law_at_separation(same, props[12] - x, &p, NULL, &slope);
        check(at.stress[0] == p && at.ddsddr[0] == slope, "stress and tangent are those of the C law, bit for bit", x);
        check(p > 0 && slope > 0, "pressure and tangent are positive", p);
        fstiff_law_at_separation(si, (props[12] - x) * 1e-3, &p, NULL, &slope);
        check(off(at.stress[0] * 1e6, p) < 1e-9 && off(at.ddsddr[0] * 1e9, slope) < 1e-9, "mm, N, MPa are SI to 1e-9",
              off(at.stress[0] * 1e6, p));

        const double h =
            1e-4 * at.stress[0] / at.ddsddr[0]; /* off by 1e-8 / 6 of the third derivative, in its measure */
        const double difference =
            (at_overclosure(props, x + h).stress[0] - at_overclosure(props, x - h).stress[0]) / (2 * h);
        check(off(at.ddsddr[0], difference) < 1e-7, "the tangent is the derivative of the stress",
              off(at.ddsddr[0], difference));
        if (print && i % 4 == 0)
            printf("%16.6f  %15.6g  %20.6g  %23.0e\n", x, at.stress[0], at.ddsddr[0], at.ddsddr[0] / difference - 1);

        double rest = 0;
        for (int j = 1; j < 9; ++j) rest += fabs(at.ddsddr[j]);
        check(rest == 0 && at.stress[1] == 0 && at.stress[2] == 0 && at.loss == 8, "no friction", rest);
        const double rdisp[3] = {x, 0.3, -0.2}, drdisp[3] = {0, 0.3, -0.2};
        const point plain = call(uinter, fresh(), props, rdisp, drdisp);
        check(memcmp(&plain, &at, sizeof at) == 0, "uinter is uinter_", x);
        point plane = fresh();
        plane.ndir = 2, plane.nstatv = 0;
        plane = call(uinter_, plane, props, rdisp, drdisp);
        check(plane.stress[0] == at.stress[0] && plane.ddsddr[0] == at.ddsddr[0] && plane.ddsddr[3] == 0 &&
                  plane.ddsddr[4] == 99,
              "two directions, no state variable", x);

        point linear = at;
        linear.linper = 1;
        const double small[3] = {1e-6, 0, 0};
        linear = call(uinter_, linear, props, small, small);
        check(linear.ddsddr[0] == at.ddsddr[0] && linear.stress[0] == at.ddsddr[0] * 1e-6 && linear.state[0] == x,
              "a perturbation step has the tangent of the last general one", x);
    }
    const point apart = at_overclosure(props, -1e36);
    check(apart.stress[0] == 0 && apart.ddsddr[0] == 0, "no partner, no stress", apart.stress[0]);

    /* Energy: some increments against Simpson's rule over the C law. */
    enum { increments = 10, intervals = 1000 };
    const double from = props[12] - light, way = light - heavy;
    point moving = at_overclosure(props, from);
    for (int i = 1; i <= increments; ++i) {
        const double rdisp[3] = {from + way * i / increments, 0, 0}, drdisp[3] = {way / increments, 0, 0};
        moving = call(uinter_, moving, props, rdisp, drdisp);
    }
    double energy = at_overclosure(props, from).energy, p;
    for (int i = 0; i <= intervals; ++i) {
        fstiff_law_at_separation(same, light - way * i / intervals, &p, NULL, NULL);
        energy += p * (i == 0 || i == intervals ? 1 : i % 2 ? 4 : 2) * way / intervals / 3;
    }
    check(off(moving.energy, energy) < 1e-9, "the energy is the integral of the pressure", off(moving.energy, energy));
    fstiff_law_free(same);
    fstiff_law_free(si);
}

/* ---- Friction ---- */

/* A place of the contact with friction: UINTER, and the same by the C interface. */
typedef struct place {
    const double* props;
    const fstiff_law* law;
    const fstiff_friction* friction;
    double rdisp[3];
    point at;
    fstiff_slip slip;
    double pressure, traction[2], tangent[9], stored;
} place;

static point moved(const place* from, double closing, double slip1, double slip2) {
    const double drdisp[3] = {closing, slip1, slip2};
    double rdisp[3];
    for (int i = 0; i < 3; ++i) rdisp[i] = from->rdisp[i] + drdisp[i];
    return call(uinter_, from->at, from->props, rdisp, drdisp);
}

/* One increment; the tangent is held against differences where no level comes or goes between these. Returns the
 * largest departure of the tangent from them, over dp/d(-d), or -1. */
static double go(place* of, double closing, double slip1, double slip2) {
    const double slip[2] = {slip1, of->at.ndir == 2 ? 0 : slip2}, h = 1e-9;
    const place from = *of;
    of->at = moved(&from, closing, slip1, slip2);
    for (int i = 0; i < 3; ++i) of->rdisp[i] += (const double[]){closing, slip1, slip2}[i];
    fstiff_friction_step(of->friction, &of->slip, of->props[12] - of->rdisp[0], slip, &of->slip, &of->pressure,
                         of->traction, of->tangent);
    double energy = -1;
    fstiff_law_energy(of->law, of->slip.separation, &energy);
    fstiff_friction_stored_energy(of->friction, &of->slip, &of->stored);
    const int n = of->at.ndir;
    double worst = 0;
    check(of->at.stress[0] == of->pressure && of->at.energy == energy + of->stored, "STRESS(1), SED are those of C",
          closing);
    check(of->at.loss >= 0, "friction gives nothing back", of->at.loss);
    for (int i = 1; i < n; ++i) check(of->at.stress[i] == of->traction[i - 1], "STRESS(2:) is that of C", slip1);
    for (int j = 0; j < n; ++j) {
        const double by[3] = {j == 0 ? h : 0, j == 1 ? h : 0, j == 2 ? h : 0};
        const point up = moved(&from, closing + by[0], slip1 + by[1], slip2 + by[2]),
                    down = moved(&from, closing - by[0], slip1 - by[1], slip2 - by[2]);
        for (int i = 0; i < n; ++i) {
            const double tangent = of->at.ddsddr[j * n + i], rise = up.stress[i] - of->at.stress[i],
                         fall = of->at.stress[i] - down.stress[i], scale = of->tangent[0];
            check(tangent == of->tangent[3 * i + j], "DDSDDR is that of C", tangent);
            if (fabs(rise - fall) / h > 2e-5 * scale) return -1;
            worst = fmax(worst, fabs(tangent - (rise + fall) / (2 * h)) / scale);
        }
    }
    return worst;
}

static place begin(const double* props, const fstiff_law* law, const fstiff_friction* friction, double pressure) {
    double d;
    fstiff_law_at_pressure(law, pressure, &d, NULL, NULL);
    place of = {.props = props, .law = law, .friction = friction, .rdisp = {props[12] - d, 0, 0}, .at = fresh()};
    of.at.nprops = property_count, of.at.nstatv = slip_variables;
    of.slip = (fstiff_slip){.size = sizeof of.slip, .separation = props[12] - of.rdisp[0]};
    return of;
}

/* Slip to and fro at 10 MPa, which ends where it began: first slip, unloading by Masing's rule, and the loss. */
static void check_cycle(const double* props, const fstiff_law* law, const fstiff_friction* friction, int print) {
    enum { quarter = 20 };
    const double most = 2e-4, mu = props[13], step = most / quarter;
    place of = begin(props, law, friction, 10);
    const double d = of.slip.separation;
    double q, half, k, lost, balance = 0, sum = 0, s = 0, begun = 0;
    if (print) puts("\n slip [mm]  STRESS(2) [MPa]  DDSDDR(2,2) [MPa/mm]  DDSDDR off differences  SFD so far [N/mm]");
    for (int i = 1; i <= 5 * quarter; ++i) {
        const double by = i <= quarter || i > 3 * quarter ? step : -step, before = of.at.stress[1];
        const double off_tangent = go(&of, 0, by, 0);
        check(off_tangent < 1e-6, "DDSDDR is the derivative of STRESS in a cycle", off_tangent);
        s += by, sum += of.at.loss, balance += (before + of.at.stress[1]) / 2 * by;
        if (i <= quarter) {
            fstiff_friction_first_slip(friction, d, s, &q, &k);
            check(off(of.at.ddsddr[4], k) < 1e-9, "dq/ds is that of the first slip", k);
        } else {
            const int down = i <= 3 * quarter;
            fstiff_friction_first_slip(friction, d, most, &q, NULL);
            fstiff_friction_first_slip(friction, d, fabs(s - (down ? most : -most)) / 2, &half, NULL);
            q = down ? q - 2 * half : -q + 2 * half;
        }
        check(fabs(of.at.stress[1] - q) < 1e-11 * mu * 10, "first slip, and Masing's rule", of.at.stress[1] - q);
        check(of.at.stress[2] == 0 && of.at.ddsddr[5] == 0 && of.at.ddsddr[7] == 0, "a straight path", of.at.stress[2]);
        if (i == quarter) begun = sum;
        if (print && i % 10 == 0) {
            printf("%10.6f  %15.6g  %20.6g  %22.0e  %18.4e\n", s, of.at.stress[1], of.at.ddsddr[4], off_tangent, sum);
        }
    }
    fstiff_friction_cycle(friction, d, most, &lost, NULL);
    check(off(sum - begun, lost) < 1e-7, "a cycle loses what fstiff_friction_cycle says", off(sum - begun, lost));
    check(off(balance - of.stored, sum) < 0.02, "work is what is stored and lost", off(balance - of.stored, sum));
    go(&of, 0, 0.01, 0);
    check(off(of.at.stress[1], mu * 10) < 1e-9, "full slip has mu p", of.at.stress[1]);
}

/* Closing, opening and turning. */
static void check_path(const double* props, const fstiff_law* law, const fstiff_friction* friction, int ndir) {
    place of = begin(props, law, friction, 10);
    of.at.ndir = ndir;
    int compared = 0, unsymmetric = 0;
    for (int i = 0; i < 200; ++i) {
        const double away = of.rdisp[0] - (props[12] - 1.3e-3), size = i % 50 < 25 ? 2e-5 : 2e-4;
        const double off_tangent = go(&of, size * sin(3 * i) - 0.2 * away, size * sin(i), size * cos(7 * i));
        if (off_tangent >= 0) ++compared;
        check(off_tangent < 1e-5, "DDSDDR is the derivative of STRESS on a path", off_tangent);
        const double q = hypot(of.at.stress[1], of.at.stress[2]);
        check(q <= props[13] * of.at.stress[0] * (1 + 1e-12), "q is mu p at most", q);
        unsymmetric += of.at.ddsddr[1] != of.at.ddsddr[ndir];
    }
    check(compared > 150 && unsymmetric > 100, "most tangents are compared, and not symmetric", compared);
    if (ndir == 2) {
        check(of.at.stress[2] == 0 && of.at.ddsddr[4] == 99, "two directions write nothing of a third", 0);
        return;
    }
    point linear = of.at;
    linear.linper = 1;
    const double small[3] = {1e-6, 2e-6, 3e-6};
    linear = call(uinter_, linear, props, small, small);
    const double k = of.at.ddsddr[0], kt = props[14] * k;
    check(linear.ddsddr[0] == k && linear.ddsddr[4] == kt && linear.ddsddr[8] == kt && linear.ddsddr[1] == 0 &&
              linear.stress[0] == k * 1e-6 && linear.stress[1] == kt * 2e-6 && linear.stress[2] == kt * 3e-6 &&
              memcmp(linear.state, of.at.state, sizeof of.at.state) == 0,
          "a perturbation step sticks", linear.ddsddr[4]);

    const double quarter[4] = {0, 1, -1, 0}, none[4] = {1, 0, 0, 1};
    memcpy(turn, quarter, sizeof turn);
    const point turned = moved(&of, 0, 0, 0);
    memcpy(turn, none, sizeof turn);
    const point same = moved(&of, 0, 0, 0); /* of.at but for the levels that were too many */
    check(fabs(turned.stress[1] + same.stress[2]) < 1e-12 && fabs(turned.stress[2] - same.stress[1]) < 1e-12 &&
              hypot(same.stress[1], same.stress[2]) > 0.1,
          "DROT turns what is remembered", turned.stress[1]);

    const double far = -1e36 - of.rdisp[0];
    of.at = moved(&of, far, 1e-3, 0);
    check(of.at.stress[0] == 0 && of.at.stress[1] == 0, "no partner, no stress", of.at.stress[1]);
    const double back[3] = {-far, 0, 0};
    const point again = call(uinter_, of.at, props, of.rdisp, back);
    check(again.stress[0] > 1 && fabs(again.stress[1]) < 1e-12, "who comes back has not slipped", again.stress[1]);
}

static void check_friction(double* props, int print) {
    fstiff_law *law = law_in(props, 1, 1), *si = law_in(props, 1e-3, 1e6);
    fstiff_friction *friction = NULL, *friction_si = NULL;
    if (fstiff_friction_make(law, props[13], props[14], &friction) != FSTIFF_OK ||
        fstiff_friction_make(si, props[13], props[14], &friction_si) != FSTIFF_OK) {
        check(0, fstiff_last_message(), props[0]);
        return;
    }
    check_cycle(props, law, friction, print);
    check_path(props, law, friction, 3);
    check_path(props, law, friction, 2);
    double q, q_si;
    fstiff_friction_first_slip(friction, 1e-3, 1e-4, &q, NULL);
    fstiff_friction_first_slip(friction_si, 1e-6, 1e-7, &q_si, NULL);
    check(off(q * 1e6, q_si) < 1e-9, "friction in mm, N, MPa is that in SI", off(q * 1e6, q_si));
    fstiff_friction_free(friction);
    fstiff_friction_free(friction_si);
    fstiff_law_free(law);
    fstiff_law_free(si);
}

static void check_stop(const double* good, int index, double value, int nprops, int linper, int nstatv,
                       const char* what) {
    double props[property_count];
    memcpy(props, good, sizeof props);
    if (index >= 0) props[index] = value;
    const int before = stops;
    point at = fresh();
    at.nprops = nprops, at.linper = linper, at.nstatv = nstatv;
    const double rdisp[3] = {0, 0, 0};
    at = call(uinter_, at, props, rdisp, rdisp);
    check(stops == before + 1, what, stops - before);
    check(at.stress[0] == 0 && at.ddsddr[0] == 0, "after a refusal there is no stress", at.stress[0]);
}

int main(void) {
    /* The fine sand-blasted surface of the paper in mm, N, MPa. */
    double props[property_count] = {1,       0.832e-3, 40e-3, 500, 0.5,    1,   1.62, 0.12,
                                    112.6e3, 1120,     0.1,   100, 2.2e-3, 0.3, 0};
    fstiff_tangential_ratio(205e3, 0.3, 205e3, 0.3, &props[14]);
    for (int law = 1; law <= 4; ++law) {
        props[0] = law;
        check_law(props, law == 1);
        if (law < 4) check_friction(props, law == 1);
    }
    check(stops == 0, "nothing was refused so far", stops);
    puts("refused, each by a line:");
    fflush(stdout);
    check_stop(props, -1, 0, 15, 0, 50, "friction of law 4");
    props[0] = 1;
    check_stop(props, -1, 0, 15, 0, 49, "friction without its state variables");
    check_stop(props, 13, -0.3, 15, 0, 50, "a negative coefficient of friction");
    check_stop(props, 14, 0, 15, 0, 50, "friction without K_t/K_n");
    check_stop(props, -1, 0, 14, 0, 50, "no K_t/K_n");
    check_stop(props, -1, 0, 12, 0, 1, "too few properties");
    check_stop(props, 0, 5, 13, 0, 1, "an unknown law");
    check_stop(props, 1, -1, 13, 0, 1, "a negative rms height");
    check_stop(props, 11, 0.01, 13, 0, 1, "a table that ends below where it begins");
    check_stop(props, -1, 0, 13, 1, 0, "a perturbation step without a state variable");
    printf(failures ? "%d checks failed\n" : "stress, tangent and energies are those of the law\n", failures);
    return failures != 0;
}
