/* SPDX-License-Identifier: BSD-3-Clause */
/**
 * \file
 * The answer of a joint in C: one stiffness for each pressure, with a band. A part of fstiff.h, which includes it.
 *
 * Units       SI: lengths [m], pressures, moduli and hardness [Pa], stiffness per nominal area [Pa/m]
 * Accuracy    the numbers of `fstiff run`, to the last digit
 */
#ifndef FSTIFF_ANSWER_H
#define FSTIFF_ANSWER_H

#ifndef FSTIFF_H
#error "include fstiff.h"
#endif

/** Heights [m], row after row; NaN marks a missing point. Where a function takes NULL in place of them, the option
 * `file` names a file. */
typedef struct fstiff_heights {
    size_t size;           /**< sizeof(fstiff_heights) */
    const double* heights; /**< rows * columns */
    size_t rows, columns;  /**< rows 0: a profile of `columns` points */
    double dx, dy;         /**< distance of the points of a row, and of the rows [m] */
} fstiff_heights;

struct fstiff_measure_options;

/** What made a face: it decides what is assumed. */
enum {
    FSTIFF_PROCESS_UNKNOWN = 0,
    FSTIFF_PROCESS_GROUND = 1,
    FSTIFF_PROCESS_TURNED = 2,
    FSTIFF_PROCESS_MILLED = 3,
    FSTIFF_PROCESS_HONED = 4,
    FSTIFF_PROCESS_LAPPED = 5,
    FSTIFF_PROCESS_POLISHED = 6,
    FSTIFF_PROCESS_BLASTED = 7,
    FSTIFF_PROCESS_ERODED = 8,
    FSTIFF_PROCESS_SUPERFINISHED = 9
};

/** Standard errors of numbers of a face; 0: that of the measurement, or none. */
typedef struct fstiff_face_errors {
    double height;                    /**< of rms_height or mean_height [m] */
    double gradient;                  /**< of the one that is given; of profile_spacing [m] */
    double peak_radius, peak_density; /**< [m], [1/m^2] */
    double fractal_dimension;
    double r, theta; /**< theta [rad] */
} fstiff_face_errors;

/** A rough face: heights, which the call measures as `fstiff measure` does, or numbers, or both: a number that is given
 * takes the place of what is measured. One that is neither (0) is assumed, with a range that is in the band. */
typedef struct fstiff_face {
    size_t size;                                  /**< sizeof(fstiff_face) */
    const fstiff_heights* heights;                /**< of the face; NULL: numbers alone */
    const struct fstiff_measure_options* options; /**< of their measurement; NULL: the defaults */
    double rms_height;                            /**< Rq, Sq [m]; 0: mean_height, or that of the heights */
    double mean_height;                           /**< Ra, Sa [m], in place of rms_height */
    double rms_gradient;                          /**< Sdq */
    double profile_gradient;                      /**< Rdq across the lay, in place of rms_gradient */
    double profile_spacing;                       /**< RSm [m], in place of rms_gradient */
    double alpha;                                 /**< Nayak's, above 1.5 */
    double hurst;                                 /**< above 0, at most 1 */
    double skewness, kurtosis;                    /**< of the heights; kurtosis 0: neither is given */
    double peak_radius, peak_density;             /**< R [m], D_p [1/m^2] */
    double max_peak_height;                       /**< R_p [m] */
    double r;                 /**< correlation of heights and curvatures of the peaks, 0 <= r < 1; with theta */
    double theta;             /**< sampling angle [rad], 0 < theta < pi/2 */
    double fractal_dimension; /**< D of a profile, 1 < D <= 1.99 */
    double fractal_roughness; /**< G [m] */
    fstiff_face_errors errors;
    int process; /**< FSTIFF_PROCESS_... */
} fstiff_face;

/** A body: E [Pa] and nu; yield strength and hardness [Pa], 0 where they are not known. */
typedef struct fstiff_solid {
    double youngs_modulus, poisson_ratio, yield_strength, hardness;
} fstiff_solid;

/** Interaction of the peaks: equation (4.11) of the paper, read in two ways. */
enum { FSTIFF_NO_INTERACTION = 0, FSTIFF_EFFECTIVE_SEPARATION = 1, FSTIFF_INTERACTION_AS_PRINTED = 2 };

/** Two bodies, and the rough faces between them. */
typedef struct fstiff_joint {
    size_t size;              /**< sizeof(fstiff_joint) */
    const fstiff_face* face;  /**< of one body */
    const fstiff_face* other; /**< of the other; NULL: it is smooth */
    fstiff_solid upper, lower;
    double effective_modulus;  /**< 1/((1-nu1^2)/E1 + (1-nu2^2)/E2) [Pa], in place of the elastic constants: `upper` has
                                    the rest of the softer body then; 0: that of the constants */
    double nominal_area;       /**< [m^2]; 0: not known */
    double interaction_length; /**< [m], of an interaction: square root of the nominal area, or 1/sqrt(D_p) */
    int interaction;           /**< FSTIFF_NO_INTERACTION ..., for fstiff_contact_make() */
    int shifts;                /**< of the map of the other face over that of the first, where both are maps; 0: 4 */
    double seating;            /**< the approach of an answer is 0 at this pressure [Pa]; 0: 1 kPa */
    int samples;               /**< surfaces drawn for the band of an answer, from 20 to 100000; 0: 400; -1: none */
    unsigned int seed;         /**< of them; 0: 2014 */
    /** Any numbers of a joint by their names in C++, in place of those above: "face.alpha", "face.Ra" and
     * "other.alpha"; "upper.density", "lower.thermal_conductivity" ...; "nominal_area"; "waves.frequency";
     * "friction.coefficient"; "conduction.thermal_film". A NaN is not given. */
    size_t number_count;
    const char* const* names;
    const double* numbers;
} fstiff_joint;

/** Causes of a band, in the order of their shares in a row of fstiff_answer_points.causes. */
enum {
    FSTIFF_CAUSE_MEASUREMENT = 0, /**< errors of the measured parameters */
    FSTIFF_CAUSE_CUT_OFFS = 1,    /**< choice of lambda_s and of the form */
    FSTIFF_CAUSE_SHAPE = 2,       /**< shape of the heights, which the measurement does not show */
    FSTIFF_CAUSE_PRIOR = 3,       /**< what is assumed */
    FSTIFF_CAUSE_LAY = 4,         /**< a profile does not show the length of ridges */
    FSTIFF_CAUSE_LAW = 5,         /**< the law by itself */
    FSTIFF_CAUSE_CONTACTS = 6,    /**< few contacts on the nominal area */
    FSTIFF_CAUSE_LONG_WAVES = 7,  /**< waves longer than the measurement */
    FSTIFF_CAUSE_HARDNESS = 8,    /**< of the softer body, where it is not known */
    FSTIFF_CAUSE_NOISE = 9,       /**< of the instrument */
    FSTIFF_CAUSE_FORM = 10,       /**< faces that are not flat */
    FSTIFF_CAUSES = 11
};

/** Destinations of an answer: arrays of `count` of the call, or NULL. */
typedef struct fstiff_answer_points {
    size_t size;           /**< sizeof(fstiff_answer_points) */
    double* stiffness;     /**< K of the nominal area [Pa/m] */
    double* stiffness_p05; /**< the ends of its 90 % band [Pa/m] */
    double* stiffness_p95;
    double* loading_stiffness;    /**< -dp/dd of the first loading where peaks yield [Pa/m]; 0 where they do not */
    double* tangential_stiffness; /**< before slip [Pa/m] */
    double* approach;             /**< since `seating` [m]; 0 where it is not known */
    double* contacts;             /**< expected on the nominal area, or on that of the heights; 0: not known */
    double* p_star;               /**< p/(E g); 0: not known */
    double* causes;               /**< FSTIFF_CAUSES shares of the band for each pressure, one row after the other */
    int* law;                     /**< that gave K: fstiff_law_name(); -1 without a K */
    int* status;                  /**< of each point */
    /** Further numbers in SI, by their keys in the CSV of `fstiff run`, such as "real_area_fraction", "force_N" or
     * "tangential_stiffness_p05_Pa_per_m"; 0 where the joint or the law has none. */
    size_t key_count;
    const char* const* keys; /**< key_count */
    double* const* numbers;  /**< key_count arrays of `count` */
} fstiff_answer_points;

/** The answer of `fstiff run` to a joint under pressures [Pa], > 0, to the last digit. A point without a K has its
 * status, and 0 in every array. Returns FSTIFF_OK, or the status of the first point without a K, with its reason as the
 * message; where all have one, the message has the numbers that are likely in another unit, a sentence a line.
 * *doubtful, unless it is NULL, becomes 1 where the command would end with exit code 4.
 * For set-up: one pressure on a joint of numbers takes some 1.5 ms, 0.2 ms where samples is -1, `approach` is NULL and
 * there are no keys. Loops take fstiff_answer_law(). */
FSTIFF_API int fstiff_answer(const fstiff_joint* joint, const double* pressures, size_t count,
                             const fstiff_answer_points* points, int* doubtful);
/** The name of a law of fstiff_answer(), such as "hybrid"; "unknown law" for any other number. Never NULL. */
FSTIFF_API const char* fstiff_law_name(int law);
/** The name of a cause, FSTIFF_CAUSE_..., as the JSON of `fstiff run` has it, such as "long_waves"; "unknown cause" for
 * any other number. Never NULL. */
FSTIFF_API const char* fstiff_cause_name(int cause);

#endif /* FSTIFF_ANSWER_H */
