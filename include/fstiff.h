/* SPDX-License-Identifier: BSD-3-Clause */
/**
 * \file
 * The C interface of fstiff: normal contact stiffness of rough surfaces, for C, Fortran and all languages that call C.
 *
 *     fstiff_face face = {sizeof face};
 *     face.rms_height = 0.8e-6, face.rms_gradient = 0.1;
 *     fstiff_joint joint = {sizeof joint, &face};
 *     joint.upper.youngs_modulus = joint.lower.youngs_modulus = 210e9;
 *     joint.upper.poisson_ratio = joint.lower.poisson_ratio = 0.3;
 *     double pressure = 10e6, K, low, high;
 *     fstiff_answer_points to = {sizeof to, &K, &low, &high};
 *     if (fstiff_answer(&joint, &pressure, 1, &to, NULL) != FSTIFF_OK) puts(fstiff_last_message());
 *
 * Units       SI, per nominal area: heights, lengths and separations [m], pressures [Pa], stiffness [Pa/m], contacts
 *             [1/m^2]
 * Accuracy    the numbers are those of the C++ library and of `fstiff run`, bit for bit
 */
#ifndef FSTIFF_H
#define FSTIFF_H

#include <stddef.h>

/* Status      every function that can fail returns FSTIFF_OK (0) or one of the codes below; the sentence is in
 *             fstiff_last_message(). No exception leaves the library, and no result is ever NaN or infinite
 * Structs     begin with their size: set it to sizeof, and unknown members to 0. They grow at their end alone: a
 *             program that was compiled with an older fstiff.h of this SONAME goes on working. Any other size is
 *             refused
 * Ownership   an object made through `**made` is freed by the fstiff_..._free of its type, which takes NULL too; *made
 *             is NULL after a failure. Text and arrays belong to the caller: they are read, or written, during the call
 *             alone
 * Threads     any number of threads may evaluate one handle, while none may free it. Each thread has its own message */

#define FSTIFF_VERSION 100 /* of this header: 10000 major + 100 minor + patch */

#if defined(_WIN32) && defined(FSTIFF_C_BUILDS_SHARED)
#define FSTIFF_API __declspec(dllexport)
#elif defined(_WIN32) && defined(FSTIFF_C_SHARED)
#define FSTIFF_API __declspec(dllimport)
#elif defined(__GNUC__)
#define FSTIFF_API __attribute__((visibility("default")))
#else
#define FSTIFF_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Status ---- */

enum {
    FSTIFF_OK = 0,
    FSTIFF_BAD_ARGUMENT = 1,   /**< a null pointer, a struct of another size, an empty array, an index out of range */
    FSTIFF_REFUSED = 2,        /**< a value or a text that the model does not allow; the message has its range */
    FSTIFF_OUT_OF_REACH = 3,   /**< the model has no state at this pressure or separation */
    FSTIFF_OUT_OF_NUMBERS = 4, /**< a result is beyond the range of double */
    FSTIFF_FILE = 5,           /**< a file that a scene names cannot be read */
    FSTIFF_OUT_OF_MEMORY = 6,
    FSTIFF_INTERNAL = 7 /**< a mistake in fstiff: please report the message */
};

/** The version of the library that is linked, such as "0.1.0". */
FSTIFF_API const char* fstiff_version(void);
/** A status in words; "unknown status" for any other number. Never NULL. */
FSTIFF_API const char* fstiff_strerror(int status);
/** The reason for the last failure in this thread, in one sentence; or, if a measurement or an answer succeeded after
 * it, its warnings, a sentence a line. Never NULL; valid until the next call of this thread. */
FSTIFF_API const char* fstiff_last_message(void);

#include "fstiff_answer.h"

/* ---- Contacts ---- */

typedef struct fstiff_contact fstiff_contact;

/** The contact of a joint by one law: contact_of() of C++, to the last digit. law: "hertz", "fractal",
 * "fractal_consistent", "greenwood_williamson", "hybrid", "persson", "plastic", "plastic_peaks", "jackson_green",
 * "kogut_etsion", "proportional", or, of the heights of a map, "summits" and "boundary_elements". What the joint does
 * not give is assumed as in fstiff_answer(), but for the hardness of a law that yields. */
FSTIFF_API int fstiff_contact_make(const char* law, const fstiff_joint* joint, fstiff_contact** made);
/** A contact of the text of a scene (docs/scene.md), length bytes of TOML: entry `law` of contact.laws and entry
 * `peaks` of the distributions of peaks, both counted from 0; `peaks` is 0 for a law without joint peaks. name is the
 * name of the text in messages, and files that it names are searched in its folder; NULL: "scene" in the current
 * folder. The points of the scene are not used. */
FSTIFF_API int fstiff_contact_of_scene(const char* text, size_t length, const char* name, size_t law, size_t peaks,
                                       fstiff_contact** made);
FSTIFF_API void fstiff_contact_free(fstiff_contact* contact);

/** Destinations of the results: arrays of `count` of the call. One that is NULL is not written, and its quantity is not
 * computed. */
typedef struct fstiff_points {
    size_t size;               /**< sizeof(fstiff_points) */
    double* pressure;          /**< [Pa] */
    double* separation;        /**< of the mean planes [m] */
    double* stiffness;         /**< K [Pa/m] */
    double* stiffness_error;   /**< a bound of the error of K for exact inputs [Pa/m]; for a map more (docs/scene.md) */
    double* loading_stiffness; /**< -dp/dd [Pa/m] */
    double* real_area_fraction; /**< A/A0 */
    double* contact_density;    /**< [1/m^2] */
    int* status;                /**< of each point */
} fstiff_points;

/** The states under pressures [Pa], > 0, and at separations [m]. A point without a state has its status, and 0 in every
 * array; the other points are computed. Returns FSTIFF_OK, or the status of the first point without a state, with its
 * message. Results may be written where the arguments were. FSTIFF_REFUSED with no array written for a quantity that
 * the law does not give. */
FSTIFF_API int fstiff_contact_at_pressures(const fstiff_contact* contact, const double* pressures, size_t count,
                                           const fstiff_points* points);
FSTIFF_API int fstiff_contact_at_separations(const fstiff_contact* contact, const double* separations, size_t count,
                                             const fstiff_points* points);

/* ---- Tabulated laws: p and K in nanoseconds ---- */

typedef struct fstiff_law fstiff_law;

/** Behaviour of a law outside its range (tabulated/contact_law.hpp). */
enum { FSTIFF_OUTSIDE_REFUSE = 0, FSTIFF_OUTSIDE_CLAMP = 1, FSTIFF_OUTSIDE_EXACT = 2, FSTIFF_OUTSIDE_EXTRAPOLATE = 3 };

/** contact tabulated between two pressures [Pa], 0 < min_pressure < max_pressure. The law does not need the contact
 * again. For a map every law but "boundary_elements" has a table, with an error of 1e-3 or less (fstiff_law_facts). */
FSTIFF_API int fstiff_law_make(const fstiff_contact* contact, double min_pressure, double max_pressure, int outside,
                               fstiff_law** made);
/** The law of fstiff_answer() between its pressures [Pa], some ten a decade: ln K by cubics over ln p, within 1e-3, and
 * -dp/dd = K. Of peaks that yield it is the law of unloading. quantile is 0.5, K itself, or 0.05 or 0.95, an end of the
 * band of K. min_pressure and max_pressure [Pa] are within the pressures that have a K; 0: the least and the greatest
 * of `pressures`. Separations count from that at max_pressure. outside is any but FSTIFF_OUTSIDE_EXACT.
 * FSTIFF_REFUSED for fewer than two pressures, another quantile, a greater range, and a K that does not rise. It takes
 * the time of fstiff_answer() and 0.6 ms; a look-up takes some nanoseconds. */
FSTIFF_API int fstiff_answer_law(const fstiff_joint* joint, const double* pressures, size_t count, double quantile,
                                 double min_pressure, double max_pressure, int outside, fstiff_law** made);
/** The law of fstiff_answer() for a joint that has carried greatest_pressure [Pa]: reversible below it, along the
 * first loading above, with which it shares separations; friction takes it. 0: the law of the first loading itself, by
 * which a joint is tightened. Of an elastic answer both are fstiff_answer_law(). Of a joint whose own greatest_pressure
 * is not 0 it is that pressure, and one of `pressures`. The rest as fstiff_answer_law(). */
FSTIFF_API int fstiff_answer_law_after(const fstiff_joint* joint, const double* pressures, size_t count,
                                       double quantile, double greatest_pressure, double min_pressure,
                                       double max_pressure, int outside, fstiff_law** made);
/** The same of a law of one contact: an elastic one is its own law after any load. relative_hardness is H/(E g), g the
 * rms gradient of both faces; 0: not known. FSTIFF_REFUSED for a pressure outside of the law or at its least one, and
 * for a law of a K that is neither -dp/dd nor that of unloading (tabulated/law_after.hpp). */
FSTIFF_API int fstiff_law_after(const fstiff_law* first_loading, double greatest_pressure, double relative_hardness,
                                fstiff_law** made);
/** The law that fstiff_law_text wrote (or ContactLaw::to_text), bit for bit; length bytes. */
FSTIFF_API int fstiff_law_of_text(const char* text, size_t length, fstiff_law** made);
/** The law as text. *length becomes its length without the closing 0. buffer of `capacity` bytes takes text and closing
 * 0; where they do not fit, nothing is written and FSTIFF_BAD_ARGUMENT returned; buffer NULL with capacity 0 asks for
 * *length alone. A law with FSTIFF_OUTSIDE_EXACT has no text. */
FSTIFF_API int fstiff_law_text(const fstiff_law* law, char* buffer, size_t capacity, size_t* length);
FSTIFF_API void fstiff_law_free(fstiff_law* law);

/** The range and the accuracy of a law. */
typedef struct fstiff_law_facts {
    size_t size;                           /**< sizeof(fstiff_law_facts) */
    double min_pressure, max_pressure;     /**< [Pa] */
    double min_separation, max_separation; /**< [m] */
    double relative_error;                 /**< the largest of p, K and d over the rms height, measured */
    int stiffness_is_slope;                /**< 1 where K is -dp/dd of the returned p */
    int outside;                           /**< FSTIFF_OUTSIDE_... */
} fstiff_law_facts;
/** facts->size must be set. */
FSTIFF_API int fstiff_law_facts_of(const fstiff_law* law, fstiff_law_facts* facts);

/** State at one separation [m]: p [Pa], K [Pa/m], -dp/dd [Pa/m], the tangent for Newton's method; at one pressure [Pa]:
 * separation [m], K [Pa/m], dK/dp [1/m]. Results that are not needed may be NULL; a call that fails leaves all of them
 * alone. */
FSTIFF_API int fstiff_law_at_separation(const fstiff_law* law, double separation, double* pressure, double* stiffness,
                                        double* slope);
FSTIFF_API int fstiff_law_at_pressure(const fstiff_law* law, double pressure, double* separation, double* stiffness,
                                      double* stiffness_slope);

/** The same for arrays: four points at a time, equal to the calls above within rounding. pressures or stiffnesses, and
 * status, may be NULL. A point that fails has its status and 0 in both arrays; the others are computed. Returns the
 * first status that is not FSTIFF_OK. Results may be written where the arguments were. */
FSTIFF_API int fstiff_law_at_separations(const fstiff_law* law, const double* separations, size_t count,
                                         double* pressures, double* stiffnesses, int* status);
/** The same for slopes -dp/dd [Pa/m] in place of K: the tangents of Newton's method, which are K only where
 * stiffness_is_slope. */
FSTIFF_API int fstiff_law_tangents_at_separations(const fstiff_law* law, const double* separations, size_t count,
                                                  double* pressures, double* slopes, int* status);
FSTIFF_API int fstiff_law_at_pressures(const fstiff_law* law, const double* pressures, size_t count,
                                       double* separations, double* stiffnesses, int* status);

/** Work per area that closes the contact from infinity to a separation [J/m^2], the integral of p, which an elastic
 * contact stores; beyond the table that of a law with FSTIFF_OUTSIDE_EXTRAPOLATE, for other laws FSTIFF_REFUSED. */
FSTIFF_API int fstiff_law_energy(const fstiff_law* law, double separation, double* energy);
/** The separation of first touch [m]: where the line through the loosest state of the table meets p = 0. The approach
 * since then is this less the separation at a pressure; since a preload, the separation there less the other. */
FSTIFF_API int fstiff_law_touch(const fstiff_law* law, double* separation);

/* ---- Friction: tangential traction, microslip and loss (tabulated/tangential_law.hpp) ---- */

/** A tabulated law with friction. Only elastic laws have one. */
typedef struct fstiff_friction fstiff_friction;

enum { FSTIFF_SLIP_LEVELS = 16 };

/** Memory of the slip of one place of the contact: plain numbers, to be kept with the other variables of a step.
 * Before the first slip the separation alone. */
typedef struct fstiff_slip {
    size_t size;                         /**< sizeof(fstiff_slip) */
    double separation;                   /**< d [m] */
    double levels[FSTIFF_SLIP_LEVELS];   /**< separations of first touch [m], rising from d on */
    double drags[FSTIFF_SLIP_LEVELS][2]; /**< drag of the contacts that first touched there, in both directions [m] */
    int count;                           /**< of levels in use */
} fstiff_slip;

/** K_t/K_n of elastic contacts that stick, by Mindlin, from Young's moduli [Pa] and Poisson's ratios of both bodies. */
FSTIFF_API int fstiff_tangential_ratio(double modulus1, double poisson1, double modulus2, double poisson2,
                                       double* ratio);
/** law with the coefficient of friction `friction`, >= 0, and K_t/K_n `ratio`, > 0. It does not need the law again, and
 * continues it outside its range as FSTIFF_OUTSIDE_EXTRAPOLATE. */
FSTIFF_API int fstiff_friction_make(const fstiff_law* law, double friction, double ratio, fstiff_friction** made);
FSTIFF_API void fstiff_friction_free(fstiff_friction* friction);

/** State at one separation [m]: traction q [Pa] and dq/ds [Pa/m] at the first slip s [m]; loss [J/m^2] and loss factor
 * of a cycle between -amplitude and amplitude [m]. Results that are not needed may be NULL; a call that fails leaves
 * all of them alone. */
FSTIFF_API int fstiff_friction_first_slip(const fstiff_friction* friction, double separation, double slip,
                                          double* traction, double* stiffness);
FSTIFF_API int fstiff_friction_cycle(const fstiff_friction* friction, double separation, double amplitude, double* lost,
                                     double* loss_factor);

/** A straight path from the state `before` to a separation [m] and by a slip [m]; a plane model has slip[1] = 0.
 * `after`, which may be `before`, has its size set. pressure and traction [Pa] are those at the end, tangent [Pa/m]
 * their derivatives d(p, q1, q2)/d(-d, s1, s2), row after row, not symmetric where something slips. Results that are
 * not needed may be NULL; a call that fails leaves all of them alone. Nothing is allocated. */
FSTIFF_API int fstiff_friction_step(const fstiff_friction* friction, const fstiff_slip* before, double separation,
                                    const double slip[2], fstiff_slip* after, double* pressure, double traction[2],
                                    double tangent[9]);
/** What many contacts go through, contact after contact and step after step, and what they answer. */
typedef struct fstiff_motion {
    size_t size; /**< sizeof(fstiff_motion) */
    size_t contacts, steps;
    const double* separations; /**< at the end of each step [m] */
    const double* slips;       /**< of each step, two numbers [m] */
    size_t directions;         /**< numbers that the motion depends on, such as amplitudes of harmonics; 0: none */
    const double* motion_by;   /**< d(-d, s1, s2) of each step, three rows of `directions` */
    int by_of_each;            /**< 0: motion_by is that of every contact; else of each of them */
    fstiff_slip* states;       /**< before the motion, and on return after it; NULL: nothing has slipped before */
    double* pressures;         /**< p [Pa] */
    double* tractions;         /**< q, two numbers a step [Pa] */
    double* tangents;          /**< as of fstiff_friction_step(), nine numbers a step: of that step alone */
    double* responses_by;      /**< d(p, q1, q2) of each step by the directions, of the whole motion */
} fstiff_motion;
/** A motion of contacts of `frictions`, one for all of them, laws = 1, or one for each. Results but responses_by may be
 * NULL; a call that fails leaves all of them alone. */
FSTIFF_API int fstiff_friction_motion(const fstiff_friction* const* frictions, size_t laws,
                                      const fstiff_motion* motion);
/** Energy stored by tangential displacement [J/m^2], in addition to fstiff_law_energy(). */
FSTIFF_API int fstiff_friction_stored_energy(const fstiff_friction* friction, const fstiff_slip* slip, double* energy);

/* ---- Measurement of profiles and maps ---- */

/** Cut-off: none. 0 leaves lambda_s to the table of the standards. */
#define FSTIFF_NO_CUT_OFF (-1.0)
enum { FSTIFF_PEAKS_ISLANDS = 0, FSTIFF_PEAKS_SUMMITS = 1 };
enum { FSTIFF_FILTER_GAUSSIAN = 0, FSTIFF_FILTER_ROBUST = 1 };

/** All 0 but the size: as `fstiff measure` does it. */
typedef struct fstiff_measure_options {
    size_t size;         /**< sizeof(fstiff_measure_options) */
    const char* detrend; /**< of a profile none, mean, line, parabola; of a map none, mean, plane, quadratic, cubic;
                              NULL: line, plane */
    double lambda_s;     /**< cut-off of short waves [m], or FSTIFF_NO_CUT_OFF, or 0: by the table */
    double lambda_c;     /**< cut-off of long waves [m]; 0, FSTIFF_NO_CUT_OFF: none, as K depends on them all */
    double tip_radius;   /**< of a stylus [m], for profiles; 0: not known */
    double resolution;   /**< of the instrument, lateral [m]; 0: not known */
    double shortest_lag; /**< the window of D [m], both or none: 0 leaves it to fstiff */
    double longest_lag;
    int filter;        /**< of lambda_c: FSTIFF_FILTER_... */
    int peaks;         /**< R and D_p of a map: FSTIFF_PEAKS_... */
    int resamples;     /**< for the errors, 2 to 100000; 0: 400 */
    unsigned int seed; /**< of the resamples; 0: 2014 */
} fstiff_measure_options;

/** A value with its standard error; all 0 where it is not known. */
typedef struct fstiff_measured {
    double value, error;
    int known; /**< 1 or 0 */
} fstiff_measured;

/** Result of a measurement. */
typedef struct fstiff_surface {
    size_t size;                       /**< sizeof(fstiff_surface) */
    size_t peaks;                      /**< counted, for R and D_p */
    double lambda_s, lambda_c;         /**< the cut-offs that were applied [m]; 0: none */
    double shape_share;                /**< 0 to 1: how much of skewness and kurtosis - 3 the hybrid law counts */
    fstiff_measured rms_height;        /**< sigma [m] */
    fstiff_measured peak_radius;       /**< R [m] */
    fstiff_measured peak_density;      /**< D_p [1/m^2] */
    fstiff_measured max_peak_height;   /**< [m] */
    fstiff_measured fractal_dimension; /**< D */
    fstiff_measured fractal_roughness; /**< G [m] */
    fstiff_measured r;
    fstiff_measured theta; /**< [rad] */
    fstiff_measured rms_gradient;
    fstiff_measured skewness;
    fstiff_measured kurtosis;
} fstiff_surface;

/** Heights [m] at equal spacing [m]; NaN marks a missing point. options NULL: the defaults. surface->size must be set.
 * A joint takes the heights themselves (fstiff_face). */
FSTIFF_API int fstiff_measure_profile(const double* heights, size_t count, double spacing,
                                      const fstiff_measure_options* options, fstiff_surface* surface);
/** Heights [m] row after row, each of `columns` points along x, dx apart; rows dy apart. */
FSTIFF_API int fstiff_measure_map(const double* heights, size_t rows, size_t columns, double dx, double dy,
                                  const fstiff_measure_options* options, fstiff_surface* surface);

/* ---- What the other commands compute, as documents ---- */

/** Output of a command, whose numbers can be taken out. Every function below takes its options as a text of lines
 * "key = value", which name the options of the command of that name (`fstiff measure --show spectrum --help`) without
 * their dashes, such as "of = acf\nlambda_s = 1 um"; a number without a unit is in SI. NULL: the defaults. A key that
 * the function does not know is refused. Warnings of the result are in fstiff_last_message() afterwards. */
typedef struct fstiff_document fstiff_document;

/** A measured curve. Where a function takes NULL in its place, an option names the file. */
typedef struct fstiff_measured_curve {
    size_t size;             /**< sizeof(fstiff_measured_curve) */
    const double* pressures; /**< [Pa], > 0 */
    const double* values;    /**< K [Pa/m], > 0, or |R| */
    const double* errors;    /**< their standard errors; NULL: not known */
    size_t count;
    int is_reflection; /**< 1: the values are |R|; 0: K */
} fstiff_measured_curve;

/** Power spectral density or autocorrelation. Options: of, taper, file and all of `fstiff measure --show spectrum`
 * that read a surface. Numbers: "psd.wavenumber_rad_per_m", "psd.psd_m3" of a profile, "psd.psd_m4" of a map,
 * "acf.lag_m", "acf.acf" ... */
FSTIFF_API int fstiff_spectrum(const fstiff_heights* heights, const char* options, fstiff_document** made);
/** A surface of known D or H. Options: kind (wm, profile, map), spacing, points, rows, hurst, rms, dimension,
 * roughness, gamma, longest, shortest, long_waves, seed; format of the text. Numbers: "heights_m", row after row,
 * "rows", "columns", "dx_m", "dy_m". The text is the file that the command writes. */
FSTIFF_API int fstiff_generate(const char* options, fstiff_document** made);
/** Reflection of a stiffness, or stiffness of a reflection or of a curve of them. Options: stiffness, or reflection (a
 * number or the name of a file); reflection_error; film_stiffness; frequency, unless a file has a column of it;
 * material, or impedance, or density and velocity; the same with 2 for the body beyond; wave, for the speed of sound of
 * a material. Numbers: "stiffness_Pa_per_m", "reflection" ...; of a curve
 * "rows.0.stiffness_Pa_per_m", "rows.1..." */
FSTIFF_API int fstiff_ultrasound(const fstiff_measured_curve* curve, const char* options, fstiff_document** made);
/** The answer of a scene, `length` bytes of TOML (NULL, of length 0: the built-in scene), and the laws that it names.
 * name is as in fstiff_contact_of_scene(). Options: surface, a file in place of the scene's [surface]. Numbers:
 * "answer.*.pressure_Pa", "answer.*.stiffness_Pa_per_m", the ends of its 90 % band "answer.*.stiffness_p05_Pa_per_m"
 * and "..._p95_Pa_per_m", "answer.*.thermal_conductance_W_per_m2K" and its ends where the scene has a gap or a
 * conductivity, "answer.*.stiffness_N_per_m" where the scene has an area, "answer.*.loading_stiffness_Pa_per_m" where
 * peaks yield, "ball.*.stiffness_N_per_m" ... where it has contact.ball_radius, "rows.*..." of the laws. Words:
 * "answer.0.law", "explanation.0", "outside_band" ... */
FSTIFF_API int fstiff_run(const char* scene, size_t length, const char* name, const char* options,
                          fstiff_document** made);
/** Parameters of a scene, as fstiff_run() takes it, from a measured curve. Options: fit, the names of the parameters
 * with commas between them; law; wave; measured, the file of the curve. Numbers: "fits.0.parameters.0.value",
 * "fits.0.chi_squared", "fits.0.covariance" ... */
FSTIFF_API int fstiff_identify(const char* scene, size_t length, const char* name, const fstiff_measured_curve* curve,
                               const char* options, fstiff_document** made);
/** The law of a scene (as above) for a finite-element program: its text is the file. Options: to (calculix, abaqus,
 * moose, comsol, law), units, tolerance, from, until, law, peaks, at. It has no numbers. */
FSTIFF_API int fstiff_export(const char* scene, size_t length, const char* name, const char* options,
                             fstiff_document** made);

/** Output of the command: JSON, of fstiff_generate() and fstiff_export() the file. buffer, capacity and length are
 * those of fstiff_law_text(). */
FSTIFF_API int fstiff_document_text(const fstiff_document* document, char* buffer, size_t capacity, size_t* length);
/** The text at path, as below, such as "answer.0.law" of fstiff_run(); buffer, capacity and length as above. */
FSTIFF_API int fstiff_document_word(const fstiff_document* document, const char* path, char* buffer, size_t capacity,
                                    size_t* length);
/** The number, or the array of numbers, at path: keys, and places in arrays from 0, with points between them; "*" is
 * every place of an array, such as "answer.*.stiffness_Pa_per_m", and a number that one of them lacks is 0. *count
 * becomes their number; values of `capacity` numbers takes all of them; if they do not fit, no number is written and
 * FSTIFF_BAD_ARGUMENT returned; values NULL with capacity 0 asks for *count alone. A null of the JSON is 0. A list of
 * lists, such as a covariance, is one row after the other. */
FSTIFF_API int fstiff_document_numbers(const fstiff_document* document, const char* path, double* values,
                                       size_t capacity, size_t* count);
/** 1 if the command would end with exit code 4, for a doubtful result; else 0. */
FSTIFF_API int fstiff_document_is_doubtful(const fstiff_document* document);
FSTIFF_API void fstiff_document_free(fstiff_document* document);

#ifdef __cplusplus
}
#endif
#endif /* FSTIFF_H */
