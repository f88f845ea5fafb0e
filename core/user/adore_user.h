/* clang-format off */
/* adore_user.h: C interface of the user routines ADRX0 to ADRX9 of Adore, for C, C++, Fortran and
 * other languages that make shared objects. This header needs no other header of Adore.
 *
 * A plug-in is a shared object. It is loaded only with `adore run --user PLUG-IN`. It exports
 *     int32_t     adore_user_abi(void);       required: returns ADORE_USER_ABI
 *     const char* adore_user_version(void);   optional: appended to the program version in files
 *     int32_t     adrx0(adore_adrx0*) ... int32_t adrx9(adore_adrx9*);   at least one of the ten
 * `adore user new adrx7 --lang c` writes a complete example.
 *
 * All units are SI and radians. Axes: x is the bearing axis, z is radial up, right-handed. The
 * azimuth theta is a rotation about +x from z: an element is at y = -r sin(theta),
 * z = r cos(theta).
 * Race 0 is the outer race ("1" in decks), race 1 the inner race. Arrays of both races are
 * [race][axis]: six numbers, x y z of the outer race first. Elements count from 0.
 *
 * Each routine is called with call.mode
 *     ADORE_READ    (-1)  once, first, in the order of the routine numbers. Set call.active = 1 to
 *                         be called again. Read your lines of records 12.x with
 *                         services->read_numbers or read_line.
 *     ADORE_START    (0)  once: documentation (services->print writes to the first pages of
 *                         PRINT.txt), constants, initial conditions. ADRX0 and ADRX8 are called
 *                         before the bearing is built.
 *     ADORE_COMPUTE  (1)  the task of the routine. ADRX1 to ADRX4 and ADRX7 are called at each
 *                         evaluation of the right-hand side. They must be pure functions of their
 *                         arguments, because steps are tried, rejected and repeated: they keep
 *                         nothing from call to call, and do no input or output.
 *     ADORE_PRINT    (2)  when a step is printed: services->print writes to that page.
 *     ADORE_STEP     (3)  at the end of each counted step: services->write writes to SOL9 (ADRX9).
 * Return values: 0: success. 1: the state is outside the range of the routine; the step is tried
 * again with a smaller size. Another number ends the run (give the reason with services->fail).
 * Input arrays are read-only. Outputs have neutral values when a call begins (the built-in value or
 * zero); outputs that the routine does not set change nothing. NaN and infinity end the run.
 *
 * Version 1. Later versions only append members; call.size is the size of the structure. */
/* clang-format on */
#ifndef ADORE_USER_H
#define ADORE_USER_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define ADORE_USER_ABI 1

enum { ADORE_READ = -1, ADORE_START = 0, ADORE_COMPUTE = 1, ADORE_PRINT = 2, ADORE_STEP = 3 };

/* What the program does for a routine. `host` is call.host. Texts end with a zero byte. */
typedef struct adore_services {
  /* Reads the next `count` numbers of records 12.x like a list-directed read: from as many lines as
   * needed; the rest of the last line is skipped. ADORE_READ only. Returns the number of values
   * read. */
  int32_t (*read_numbers)(void* host, double* values, int32_t count);
  /* Reads the next line unchanged; returns 0 if there is none. ADORE_READ only. */
  int32_t (*read_line)(void* host, char* text, int32_t size);
  void (*print)(void* host, const char* text); /* lines for PRINT.txt: ADORE_START, ADORE_PRINT */
  void (*write)(void* host,
                const char* text); /* unchanged to SOL9: ADRX9, ADORE_START and ADORE_STEP */
  void (*fail)(void* host, const char* text); /* the reason of a return value other than 0 */
} adore_services;

/* The bearing that is simulated. */
typedef struct adore_bearing {
  int32_t elements;        /* number of rolling elements */
  int32_t rollers;         /* 0 balls, 1 rollers */
  double element_diameter; /* [m] */
  double pitch_diameter;   /* [m] */
  double element_mass;     /* [kg] */
  double race_speed[2];    /* constant part of the race speeds about x, record 9.1.2 [rad/s] */
  double time_scale;       /* unit of dimensionless times of the deck [s]; 0: not yet known */
} adore_bearing;

typedef struct adore_call {
  int32_t abi;    /* ADORE_USER_ABI of the program */
  int32_t size;   /* size of the whole structure [bytes] */
  int32_t hook;   /* number of the routine, 0 to 9 */
  int32_t mode;   /* ADORE_READ ... */
  int32_t active; /* ADORE_READ: set it to 1 to be called */
  int32_t unused;
  int64_t step; /* counted steps so far */
  double time;  /* [s] */
  void* user;   /* free for the routine: a pointer set in ADORE_READ or ADORE_START is passed on */
  void* host;   /* argument of the services */
  const adore_services* services;
  const adore_bearing* bearing; /* null in ADORE_READ, and for ADRX0 and ADRX8 */
} adore_call;

/* ADRX0: a material of the user's data base, for each part whose material code is 2. */
enum {
  ADORE_ELEMENT = 0,
  ADORE_OUTER_RACE = 1,
  ADORE_INNER_RACE = 2,
  ADORE_HOUSING = 3,
  ADORE_SHAFT = 4,
  ADORE_CAGE = 5
};
typedef struct adore_adrx0 {
  adore_call call;
  int32_t part; /* ADORE_ELEMENT ... */
  int32_t unused;
  /* in and out: the program's default values of the part when the call begins */
  double density;              /* [kg/m^3] */
  double elastic_modulus;      /* [Pa] */
  double poisson_ratio;        /* [-] */
  double thermal_expansion;    /* [1/K] */
  double conductivity;         /* [W/(m K)] */
  double specific_heat;        /* [J/(kg K)] */
  double elastic_strain_limit; /* [-] */
  double hardness;             /* indentation pressure [Pa] */
  double wear_coefficient;     /* Archard's K [-] */
  double fatigue_limit_stress; /* von Mises [Pa] */
} adore_adrx0;

/* ADRX1: time-dependent loads and motions of the races, suppressed motions, motion of the base
 * frame. */
typedef struct adore_adrx1 {
  adore_call call;
  /* ADORE_START, out */
  int32_t drives[2];   /* [race] 1: the routine gives the accelerations of this race: its six
                          velocities start at those of the deck plus start_velocity and start_spin,
                          and follow the accelerations */
  int32_t moves_frame; /* 1: frame_acceleration is used */
  int32_t suppress_element_axial; /* with kDOF = 6: 1 sets these accelerations to zero, as
                                     kDOF 1 to 5 do */
  int32_t suppress_element_tilt;
  int32_t suppress_element_all;
  int32_t suppress_cage_axial;
  int32_t suppress_cage_tilt;
  double start_velocity[6]; /* [race][axis] [m/s] */
  double start_spin[2];     /* about x, added to the deck's speed [rad/s] */
  double longest_step;      /* longest step that resolves the prescribed motion [s]; 0: no limit */
  double kinks[8];          /* times of jumps in the loads or motions: steps end there [s] */
  int32_t kink_count;
  int32_t unused;
  /* ADORE_COMPUTE, in */
  double position[6]; /* displacement of the race from its place in the unloaded bearing
                         [race][axis] [m] */
  double velocity[6]; /* [m/s]; 0 along directions in balance (mode 2), which have no inertia */
  double omega[6];    /* angular velocity [rad/s] */
  double angle[2];    /* rotation of the race about its axis since the start [rad] */
  /* ADORE_COMPUTE, out; zero when the call begins */
  double force[6];        /* force on the race [N]. It moves the race in free directions (kDCR = 1,
                             kFD = 0) and in directions of force balance (mode 2). In fixed
                             directions, the support of the race takes it */
  double moment[6];       /* moment on the race about its center, likewise (kMD = 0) [N m] */
  double acceleration[6]; /* of the center of a driven race, in fixed directions [m/s^2] */
  double angular_acceleration[6]; /* of a driven race, about its axes at the start [rad/s^2]; for
                                     the inner race in mode 2 about x only */
  double frame_acceleration[3];   /* of the origin of the base frame, in the axes of the frame;
                                     inertial forces have the opposite direction [m/s^2] */
  /* Rotation of the frame (moves_frame): Omega about its own axes, and dOmega/dt, which must be the
     derivative of Omega. Positions, velocities, loads and gravity are in the moving frame. */
  double frame_omega[3];                /* [rad/s] */
  double frame_angular_acceleration[3]; /* [rad/s^2] */
} adore_adrx1;

/* ADRX2 flange, ADRX3 pocket, ADRX4 guide land: normal force as a function of the gap. One call has
 * all contacts of the kind with a negative gap; open contacts have no force. */
typedef struct adore_force {
  adore_call call;
  int64_t n;              /* number of contacts */
  const int32_t* element; /* [n] rolling element; ADRX4: guide land, from 0 */
  const int32_t*
      surface; /* [n] ADRX2: 2*race + side (0 at -x), ADRX3: surface of the pocket, ADRX4: race */
  const double* gap;      /* [n] negative: overlap [m] */
  const double* gap_rate; /* [n] its time derivative [m/s] */
  const double* built_in; /* [n] force of the program's own law [N] */
  double* force;          /* [n] out: >= 0 pushes apart; built_in when the call begins [N] */
} adore_force;

/* ADRX5 roller radius, ADRX6 race radius and groove curvature: deviations from the ideal surface.
 * The routine is called once at set-up with a grid of points. The values are interpolated later. */
typedef struct adore_surface {
  adore_call call;
  int32_t race;             /* ADRX6; -1 for ADRX5 */
  int32_t element;          /* ADRX5; -1 for ADRX6 */
  int64_t n;                /* number of points */
  const double* axial;      /* [n] along the element, from mid length; across the groove [m] */
  const double* azimuth;    /* [n] around the body, from its z axis about +x [rad] */
  double* radius;           /* [n] out: increase of the radius of the body [m] */
  double* curvature_factor; /* [n] out, ADRX6 of balls: added to the groove factor [-] */
} adore_surface;

/* ADRX7: traction coefficient as a function of slip. */
enum {
  ADORE_ELEMENT_RACE = 0,   /* kTrac = -1 */
  ADORE_ELEMENT_CAGE = 1,   /* kCPTrac = -1 */
  ADORE_CAGE_RACE = 2,      /* kCRTrac = -1 */
  ADORE_ROLLER_FLANGE = 3,  /* kRFTrac = -1 */
  ADORE_ELEMENT_ELEMENT = 4 /* kRRTrac = -1 */
};
typedef struct adore_adrx7 {
  adore_call call;
  int32_t kind; /* ADORE_ELEMENT_RACE ... */
  int32_t race; /* of kinds 0, 2 and 3; -1: not known */
  /* ADORE_START, in and out: once for each kind that the deck asks for */
  double slip_scale; /* slip range over which kappa rises from 0 [m/s]; integrals are split there.
                        0: none */
  int32_t wants_points; /* 1: the routine reads pressure; 0: pressure is not computed (faster) */
  int32_t unused;
  /* ADORE_COMPUTE, in. Point k of contact i is at [k*stride + i] */
  int64_t n;          /* contacts of this kind, open ones included (load 0) */
  int64_t points;     /* points of each contact area; 1 where slip is taken at one point */
  int64_t stride;     /* >= n */
  const double* slip; /* [points*stride] magnitude of the slip velocity, > 0 [m/s] */
  const double*
      pressure; /* [points*stride] of the contact at that point [Pa]; null unless wants_points */
  const double* load;          /* [n] contact load Q [N]; of roller slices per length [N/m] */
  const double* peak_pressure; /* [n] Hertz pressure [Pa] */
  const double* half_major;    /* [n] across rolling [m] */
  const double* half_minor;    /* [n] along rolling [m] */
  const double*
      entrainment; /* [n] mean velocity of both surfaces along rolling, to the contact [m/s]; with
                      the curvature, loads and widths what film formulas (EHD) need */
  const double* curvature;   /* [n] of both bodies along rolling, 0: not known [1/m] */
  const double* middle_slip; /* [n] slip in the middle [m/s] */
  /* ADORE_COMPUTE, out */
  double* kappa; /* [points*stride] traction over pressure, >= 0 opposes slip [-] */
} adore_adrx7;

/* ADRX8: imperfections of elements (kReGeoImp = 3) and pockets (kCagePocImp = 4), inertia of
 * elements (kReIP = 3). Called once, ADORE_COMPUTE, after the deck is read. When the call
 * begins, arrays contain zeros or the ideal inertia. */
typedef struct adore_adrx8 {
  adore_call call;
  int32_t elements_wanted, pockets_wanted,
      inertia_wanted; /* which of the three the deck asks for */
  int32_t unused;
  int64_t n;                  /* elements */
  double* diameter;           /* [n] increase over the nominal diameter [m] */
  double* crown_radius;       /* [n] rollers [m] */
  double* length;             /* [n] rollers [m] */
  double* central_length;     /* [n] rollers [m] */
  double* land_offset;        /* [n] rollers [m] */
  double* pocket_clearance1;  /* [n] diametral [m] */
  double* pocket_clearance2;  /* [n] [m] */
  double* pocket_thickness;   /* [n] of the wall [m] */
  double* pocket_axial;       /* [n] [m] */
  double* pocket_angular;     /* [n] [rad] */
  double* pocket_tilt;        /* [3*n] about x, y, z; those of pocket i at [3*i] [rad] */
  double mass;                /* of every element [kg] */
  double moments[3];          /* principal [kg m^2] */
  double geometric_centre[3]; /* from the mass center [m] */
  double frame[3];            /* angles from the principal to the geometric axes [rad] */
} adore_adrx8;

/* ADRX9: results at the end of each counted step (ADORE_STEP), to be written to SOL9. */
typedef struct adore_adrx9 {
  adore_call call;
  double step_size;            /* [s] */
  double total_heat;           /* present dissipation: the sum of source_heat [W] */
  int64_t n;                   /* elements */
  const double* x;             /* [n] axial position of the center [m] */
  const double* r;             /* [n] radial position of the center [m] */
  const double* theta;         /* [n] azimuth, including whole revolutions [rad] */
  const double* load;          /* [2*n] all elements at the outer race, then at the inner one [N] */
  const double* contact_angle; /* [2*n] [rad] */
  int64_t sources;             /* number of heat sources */
  const int32_t*
      source_kind; /* [sources] kind of contact as for ADRX7; -1: a whole effect, see source_name */
  const int32_t* source_element; /* [sources] -1: none */
  const int32_t* source_race;    /* [sources] 0, 1; -1: none */
  const double* source_heat;     /* [sources] [W] */
  const double*
      source_place; /* [3*sources] x, y, z of source i at [3*i]; 0 for a whole effect [m] */
  const double* source_size;      /* [2*sources] half axes: across and along rolling [m] */
  const char* const* source_name; /* [sources] "outer race contacts" */
  /* ADORE_START, out */
  int32_t wants_channels; /* 1: the arrays below are filled in ADORE_STEP */
  int32_t unused;
  /* ADORE_STEP, in: the channels of RESULTS.h5, full precision, SI and rad */
  int64_t channels;
  const char* const* channel_name; /* [channels] "contact.load", as `adore show RESULTS.h5` lists */
  const int32_t* channel_size;     /* [channels] values of one step */
  const int64_t* channel_first;    /* [channels] of channel_value */
  int64_t channel_values;          /* of all channels */
  const double* channel_value;     /* [channel_values] element, then race, side or surface, then
                                      component */
} adore_adrx9;

#ifdef __cplusplus
}
#endif
#endif
