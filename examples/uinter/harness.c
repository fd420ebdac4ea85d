/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Calls UINTER as Abaqus would, and holds what it returns against the law of fstiff.h and against differences of the stress.
 * Prints a table of the first law; the exit code is the number of checks that failed.
 */
#include <fstiff.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Every argument by address, arrays by columns; behind the last the lengths of the three names, as compilers of Fortran pass. */
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

enum { directions = 3, property_count = 13 };

/* What one point of the slave face hands on and gets back. */
typedef struct point {
    double stress[3], ddsddr[9], state[1], energy;
    int ndir, nstatv, nprops, linper;
} point;

static point call(void (*entry)(ARGUMENTS), point at, const double* props, const double* rdisp, double step) {
    double amki[9] = {1}, amski[9] = {2}, flux[2] = {3, 4}, ddfddt[4] = {5}, ddsddt[6] = {6}, ddfddr[6] = {7};
    double sfd = 8, spd = 9, svd = 10, scd = 11, pnewdt = 1e36;
    const double drdisp[3] = {step, 0, 0}, pair[2] = {20, 20}, none[2] = {0, 0}, one = 1,
                 axes[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const int number = 7, zero = 0, three = 3;
    int open = -1, state = -1, discontinuity = 0;
    char name[80];
    memset(name, ' ', sizeof name);
    entry(at.stress, at.ddsddr, amki, amski, flux, ddfddt, ddsddt, ddfddr, at.state, &at.energy, &sfd, &spd, &svd, &scd,
          &pnewdt, rdisp, drdisp, pair, none, pair, none, pair, &one, &one, name, name, name, props, axes, axes, axes,
          &one, &one, &number, &at.ndir, &at.nstatv, &zero, &at.nprops, &three, &number, &number, &zero, &at.linper,
          &open, &state, &discontinuity, &zero, sizeof name, sizeof name, sizeof name);
    check(amki[0] == 1 && amski[0] == 2 && flux[0] == 3 && flux[1] == 4 && ddfddt[0] == 5 && ddsddt[0] == 6 &&
              ddfddr[0] == 7 && sfd == 8 && spd == 9 && svd == 10 && scd == 11 && pnewdt == 1e36 && open == -1 &&
              state == -1 && discontinuity == 0,
          "what does not belong to the contact stays as it was", 0);
    return at;
}

static point fresh(void) {
    point at;
    memset(&at, 0, sizeof at);
    for (int i = 0; i < 9; ++i) at.ddsddr[i] = 99;
    at.ndir = directions, at.nstatv = 1, at.nprops = property_count;
    return at;
}

/* The state at one overclosure. */
static point at_overclosure(const double* props, double overclosure) {
    const double rdisp[3] = {overclosure, 0.3, -0.2};
    return call(uinter_, fresh(), props, rdisp, 0);
}

/* The law of the same properties by the C interface, lengths times `length`, pressures times `pressure`. */
static fstiff_law* law_in(const double* props, double length, double pressure) {
    static const char* const names[] = {"hertz", "fractal_consistent", "hybrid", "plastic_peaks"};
    fstiff_roughness surface = {.size = sizeof surface,
                                .rms_height = props[1] * length,
                                .peak_radius = props[2] * length,
                                .peak_density = props[3] / length / length,
                                .r = props[4],
                                .theta = props[5],
                                .fractal_dimension = props[6],
                                .rms_gradient = props[7]};
    fstiff_body body = {.size = sizeof body, .effective_modulus = props[8] * pressure, .hardness = props[9] * pressure};
    fstiff_contact* contact = NULL;
    fstiff_law* law = NULL;
    if (fstiff_contact_make(names[(int)props[0] - 1], &surface, &body, &contact) != FSTIFF_OK ||
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
        check(rest == 0 && at.stress[1] == 0 && at.stress[2] == 0, "no friction", rest);
        const double rdisp[3] = {x, 0.3, -0.2};
        const point plain = call(uinter, fresh(), props, rdisp, 0);
        check(memcmp(&plain, &at, sizeof at) == 0, "uinter is uinter_", x);
        point plane = fresh();
        plane.ndir = 2, plane.nstatv = 0;
        plane = call(uinter_, plane, props, rdisp, 0);
        check(plane.stress[0] == at.stress[0] && plane.ddsddr[0] == at.ddsddr[0] && plane.ddsddr[3] == 0 &&
                  plane.ddsddr[4] == 99,
              "two directions, no state variable", x);

        point linear = at;
        linear.linper = 1;
        const double small[3] = {1e-6, 0, 0};
        linear = call(uinter_, linear, props, small, 1e-6);
        check(linear.ddsddr[0] == at.ddsddr[0] && linear.stress[0] == at.ddsddr[0] * 1e-6 && linear.state[0] == x,
              "a perturbation step has the tangent of the last general one", x);
    }
    const point apart = at_overclosure(props, -1e36);
    check(apart.stress[0] == 0 && apart.ddsddr[0] == 0, "no partner, no stress", apart.stress[0]);

    /* Energy: many small increments against Simpson's rule over the C law. */
    enum { increments = 4000, intervals = 1000 };
    const double from = props[12] - light, way = light - heavy;
    point moving = at_overclosure(props, from);
    for (int i = 1; i <= increments; ++i) {
        const double rdisp[3] = {from + way * i / increments, 0, 0};
        moving = call(uinter_, moving, props, rdisp, way / increments);
    }
    double energy = 0, p;
    for (int i = 0; i <= intervals; ++i) {
        fstiff_law_at_separation(same, light - way * i / intervals, &p, NULL, NULL);
        energy += p * (i == 0 || i == intervals ? 1 : i % 2 ? 4 : 2) * way / intervals / 3;
    }
    check(off(moving.energy, energy) < 1e-5, "the energy is the integral of the pressure", off(moving.energy, energy));
    fstiff_law_free(same);
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
    at = call(uinter_, at, props, rdisp, 0);
    check(stops == before + 1, what, stops - before);
    check(at.stress[0] == 0 && at.ddsddr[0] == 0, "after a refusal there is no stress", at.stress[0]);
}

int main(void) {
    /* The fine sand-blasted surface of the paper in mm, N, MPa. */
    double props[property_count] = {1, 0.832e-3, 40e-3, 500, 0.5, 1, 1.62, 0.12, 112.6e3, 1120, 0.1, 100, 2.2e-3};
    for (int law = 1; law <= 4; ++law) {
        props[0] = law;
        check_law(props, law == 1);
    }
    check(stops == 0, "nothing was refused so far", stops);
    puts("refused, each by a line:");
    fflush(stdout);
    check_stop(props, -1, 0, 12, 0, 1, "too few properties");
    check_stop(props, 0, 5, 13, 0, 1, "an unknown law");
    check_stop(props, 1, -1, 13, 0, 1, "a negative rms height");
    check_stop(props, 11, 0.01, 13, 0, 1, "a table that ends below where it begins");
    check_stop(props, -1, 0, 13, 1, 0, "a perturbation step without a state variable");
    printf(failures ? "%d checks failed\n" : "stress, tangent and energy are those of the law\n", failures);
    return failures != 0;
}
