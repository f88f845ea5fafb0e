"""Written by write_stubs.py from the record schema; do not edit."""

import numpy as np

class DeckVariables:
    """Every variable of all records; a deck has those of its records."""

    mode: int
    """Record 1. Kind of simulation. 0 integrates the motion of every body. 1 and 2 replace fast contact vibration by
    force balance, which allows larger steps. A negative value stops after the static solution."""
    kDCR: int
    """Record 1. Source of the constraints on the motion of the races. With the built-in constraints, both races keep
    the position of the static solution and rotate at their given speeds."""
    kDOF: int
    """Record 1. Degrees of freedom that are suppressed in addition to those that mode replaces by force balance. A
    suppressed degree of freedom keeps its initial velocity. Its acceleration is zero, and no force balance is
    solved for it."""
    kIcOpt: int
    """Record 1. Initial state of a dynamic run. Use -1 to start a new run from an earlier final state, and 1 to
    continue a stopped run."""
    kFnOpt: int
    """Record 1. Names of the data files. The defaults are MASTER, FINAL and SOL1 to SOL8."""
    kPrtOpt: int
    """Record 1. Contents of each printed step in PRINT.txt. The sections are 1 (rolling elements), 2 (races and
    cage), 3 (applied parameters) and 4 (summary of the step)."""
    kPrtFreq: int
    """Record 1. Interval between printed steps. Step 0 is time zero."""
    kPltFreq: int
    """Record 1. Interval between the steps that are stored in the plot files SOL1 to SOL7."""
    kAGraf: int
    """Record 1. Interval between the steps that are stored for animation in SOL8. 0 stores no animation."""
    kLifeFreq: int
    """Record 1. Interval between the steps for which SOL7 contains a fatigue life. The life of a step is computed
    from the loads of that step alone. The life of the whole run uses the loads of every step."""
    kTherm: int
    """Record 1. Thermal analysis. When it is on, temperatures follow from the heat that the run generates. Records
    3.5 and 9.7 then specify coolant and heat transfer."""
    maxStps: int
    """Record 1. Largest number of counted integration steps (see nStps). The run ends at this number of counted
    steps or at fTime, whichever comes first."""
    nStps: int
    """Record 1. Interval between counted integration steps. With n, only every n-th integration step is counted and
    stored. With 0 or 1, every integration step is counted and stored."""
    intMet: int
    """Record 1. Integration method. The explicit method of order 5 suits most runs. Codes above 18 are extensions,
    which the classic program does not have."""
    stpInit: float
    """Record 2.1. First trial step in dimensionless time (multiples of the time scale that PRINT.txt reports). When
    a run is continued, 0 reuses the last step size stored in file MASTER."""
    stpMin: float
    """Record 2.1. Smallest step in dimensionless time. A step of this size is accepted even if its error is too
    large; the run reports the number of such steps. stpMin = stpMax gives a constant step."""
    stpMax: float
    """Record 2.1. Largest step in dimensionless time. It limits the time resolution of plots."""
    fTime: float
    """Record 2.1. End of the run in dimensionless time."""
    tol: float
    """Record 2.1. Allowed error per step, relative to the scale of each variable. A smaller value makes the run more
    accurate and slower."""
    qFac: float
    """Record 2.1. Load ratio up to which rolling elements are quasi-static in mode 0. An element is in force balance
    while its contact load is at most qFac times the largest applied load. With 0, no element is quasi-static."""
    kFD11: int
    """Record 2.2. Translation constraint of the outer race along x. With 0, the race moves freely under its load."""
    kFD21: int
    """Record 2.2. Translation constraint of the outer race along y. With 0, the race moves freely under its load."""
    kFD31: int
    """Record 2.2. Translation constraint of the outer race along z. With 0, the race moves freely under its load."""
    kFD12: int
    """Record 2.2. Translation constraint of the inner race along x. With 0, the race moves freely under its load."""
    kFD22: int
    """Record 2.2. Translation constraint of the inner race along y. With 0, the race moves freely under its load."""
    kFD32: int
    """Record 2.2. Translation constraint of the inner race along z. With 0, the race moves freely under its load."""
    kMD11: int
    """Record 2.2. Rotation constraint of the outer race about x. With 0, the moments on the race change its speed.
    Without user routine ADRX1, the external moment is zero."""
    kMD21: int
    """Record 2.2. Rotation constraint of the outer race about y. With 0, the moments on the race change its speed.
    Without user routine ADRX1, the external moment is minus appMomY."""
    kMD31: int
    """Record 2.2. Rotation constraint of the outer race about z. With 0, the moments on the race change its speed.
    Without user routine ADRX1, the external moment is minus appMomZ."""
    kMD12: int
    """Record 2.2. Rotation constraint of the inner race about x. With 0, the moments on the race change its speed.
    Without user routine ADRX1, the external moment is zero."""
    kMD22: int
    """Record 2.2. Rotation constraint of the inner race about y. With 0, the moments on the race change its speed.
    Without user routine ADRX1, the external moment is appMomY."""
    kMD32: int
    """Record 2.2. Rotation constraint of the inner race about z. With 0, the moments on the race change its speed.
    Without user routine ADRX1, the external moment is appMomZ."""
    masName: str
    """Record 2.3. Name of the file with the data for continuing a run, at most 10 characters."""
    finName: str
    """Record 2.3. Name of the file of the final state, at most 10 characters. A run can start from this state
    (kIcOpt)."""
    pltNames1: str
    """Record 2.3. Name of the plot file of monitored body 1, at most 10 characters."""
    pltNames2: str
    """Record 2.3. Name of the plot file of monitored body 2, at most 10 characters."""
    pltNames3: str
    """Record 2.3. Name of the plot file of monitored body 3, at most 10 characters."""
    pltNames4: str
    """Record 2.3. Name of the plot file of monitored body 4, at most 10 characters."""
    pltNames5: str
    """Record 2.3. Name of the plot file of monitored body 5, at most 10 characters."""
    pltNames6: str
    """Record 2.3. Name of the plot file of monitored body 6, at most 10 characters."""
    pltNames7: str
    """Record 2.3. Name of the file of power loss and life, at most 10 characters."""
    pltNames8: str
    """Record 2.3. Name of the file of animation data, at most 10 characters."""
    runID: str
    """Record 3.1. Bearing code or name of the run, at most 36 characters. It is printed on every page and stored in
    every data file. It must be the same when a run is continued."""
    kUnit: int
    """Record 3.2. Unit system of all dimensional values in the deck and in the output files."""
    kBrg: int
    """Record 3.2. Bearing type. It determines which geometry record (5A to 5E) follows."""
    nRe: int
    """Record 3.2. Number of rolling elements. It may exceed 40, the limit of the classic program. Some classic file
    formats have space for at most 88 elements."""
    nCseg: int
    """Record 3.2. Number of cage segments. 0 is no cage, 1 is a one-piece cage, and n is a cage cut into n equal
    segments."""
    kRaceFlex: int
    """Record 3.2. Flexibility of the outer race. Only rigid races can be simulated."""
    kReGeoImp: int
    """Record 3.2. Geometry errors of the rolling elements. A list of diameters always has 40 values."""
    kRaceGeoImp1: int
    """Record 3.2. Geometry errors of the outer race."""
    kRaceGeoImp2: int
    """Record 3.2. Geometry errors of the inner race."""
    kFlngInd11: int
    """Record 3.2. Roller guide flange on the outer race, negative x side. Ball and spherical roller bearings have no
    guide flanges."""
    kFlngInd21: int
    """Record 3.2. Roller guide flange on the outer race, positive x side. Ball and spherical roller bearings have no
    guide flanges."""
    kFlngInd12: int
    """Record 3.2. Roller guide flange on the inner race, negative x side. Ball and spherical roller bearings have no
    guide flanges."""
    kFlngInd22: int
    """Record 3.2. Roller guide flange on the inner race, positive x side. Ball and spherical roller bearings have no
    guide flanges."""
    kFS1: int
    """Record 3.3. Force or displacement along x (bearing axis, thrust normally positive) as input to the static
    solution."""
    kFS2: int
    """Record 3.3. Force or displacement along y as input to the static solution."""
    kFS3: int
    """Record 3.3. Force or displacement along z (usual radial load axis) as input to the static solution."""
    kFS4: int
    """Record 3.3. Moment or misalignment about y as input to the static solution."""
    kFS5: int
    """Record 3.3. Moment or misalignment about z as input to the static solution."""
    kAngVel: int
    """Record 3.3. Rule for the spin axis of balls in the static solution. Race control suits fast bearings. Least
    frictional heat suits slow bearings. Codes 0 and 1 are not used for balls in friction equilibrium (run option
    ballFriction)."""
    kStif: int
    """Record 3.3. Number of speeds in the table of stiffness against speed. 0 means no table."""
    kChrn: int
    """Record 3.3. Medium that causes churning drag on rolling elements and cage."""
    kReMat: int
    """Record 3.3. Material of the rolling elements. 0 is the default material, and 1 takes the properties from the
    deck. The material table lists the other codes."""
    kRaceMat1: int
    """Record 3.3. Material of the outer race. 0 is the default material, and 1 takes the properties from the deck.
    The material table lists the other codes."""
    kRaceMat2: int
    """Record 3.3. Material of the inner race. 0 is the default material, and 1 takes the properties from the deck.
    The material table lists the other codes."""
    kHsngMat: int
    """Record 3.3. Material of the housing. 0 is the default material, and 1 takes the properties from the deck. The
    material table lists the other codes."""
    kShftMat: int
    """Record 3.3. Material of the shaft. 0 is the default material, and 1 takes the properties from the deck. The
    material table lists the other codes."""
    kLifeCons: int
    """Record 3.3. Source of the constants of the fatigue life models."""
    kVarLoad: int
    """Record 3.4. Variation of loads over time."""
    kVarSpeed: int
    """Record 3.4. Variation of race speeds over time."""
    kRotFrame: int
    """Record 3.4. Orbital motion of the whole bearing, as in a planetary gear."""
    kReIP: int
    """Record 3.4. Source of mass and inertia of the rolling elements."""
    kRaceIP1: int
    """Record 3.4. Source of mass and inertia of the outer race. It is needed only if that race is free to move."""
    kRaceIP2: int
    """Record 3.4. Source of mass and inertia of the inner race. It is needed only if that race is free to move."""
    kNumPltElem: int
    """Record 3.4. Number of bodies whose motion is stored for plots. The classic files SOL1 to SOL6 contain at most
    six bodies."""
    kPltElemInd: np.ndarray
    """Record 3.4. Numbers of the bodies whose motion is stored, in increasing order. 1 to nRe are rolling elements.
    The nCseg cage segments, the outer race and the inner race follow."""
    kCoolant: int
    """Record 3.5. Coolant that carries the heat away. 0 means no circulating coolant."""
    kBaseTemp: int
    """Record 3.5. Location of the reference temperature baseTemp (record 9.7)."""
    kHTC: int
    """Record 3.5. Source of the convection coefficients of rolling elements and cage."""
    kGeoMod: int
    """Record 3.5. Interval between updates of the geometry for thermal expansion."""
    kMatPropMod: int
    """Record 3.5. Temperature dependence of the material properties."""
    brgBore: float
    """Record 4 [m]. Bore diameter of the bearing."""
    brgOD: float
    """Record 4 [m]. Outside diameter of the bearing."""
    shftID: float
    """Record 4 [m]. Inside diameter of a hollow shaft; 0 for a solid shaft. Thermal analysis replaces 0 by a small
    bore and reports it."""
    hsngOD: float
    """Record 4 [m]. Outside diameter of the housing. It determines how much an interference fit shrinks the outer
    race."""
    raceWidth1: float
    """Record 4 [m]. Width of the outer race."""
    raceWidth2: float
    """Record 4 [m]. Width of the inner race."""
    bReDia: float
    """Record 5A [m]. Nominal ball diameter."""
    pitchDia: float
    """Record 5A [m]. Pitch diameter: diameter of the circle of ball centers."""
    freeConAng: float
    """Record 5A [deg]. Free contact angle (without load, before mounting). A value above 0 determines the clearance.
    With 0, the angle is computed from freeIntCls. Enter 90 degrees for a thrust bearing."""
    freeIntCls: float
    """Record 5A [m]. Internal diametral clearance before mounting, used when freeConAng is 0. Negative means
    interference."""
    raceCurFac1: float
    """Record 5A. Groove radius of the outer race divided by ball diameter; above 0.5 and below 10, usually 0.515 to
    0.53."""
    raceCurFac2: float
    """Record 5A. Groove radius of the inner race divided by ball diameter; above 0.5 and below 10, usually 0.515 to
    0.53."""
    shoulderDia1: float
    """Record 5A [m]. Shoulder diameter of the outer race. It is used only for the distance of the contact from the
    shoulder edge."""
    shoulderDia2: float
    """Record 5A [m]. Shoulder diameter of the inner race. It is used only for the distance of the contact from the
    shoulder edge."""
    shimThickness1: float
    """Record 5A [m]. Thickness of the grinding shim of a split outer race (gothic arch); 0 if the race is not split."""
    shimThickness2: float
    """Record 5A [m]. Thickness of the grinding shim of a split inner race (gothic arch); 0 if the race is not split."""
    rmsAspHt1: float
    """Record 5A [m]. Composite rms roughness of rolling element and outer race: square root of the sum of their
    squared rms roughness values. The film parameter is the film thickness divided by this value."""
    rmsAspHt2: float
    """Record 5A [m]. Composite rms roughness of rolling element and inner race: square root of the sum of their
    squared rms roughness values. The film parameter is the film thickness divided by this value."""
    bReCrn: float
    """Record 5B.1 [m]. Crown radius of the roller profile. 0 means a straight roller without crown; bReCenLen is
    then not used."""
    bReLen: float
    """Record 5B.1 [m]. Roller length from end to end."""
    bReCenLen: float
    """Record 5B.1 [m]. Length of the uncrowned central part of the roller; at most the roller length."""
    bReCorRad1: float
    """Record 5B.1 [m]. Corner radius of the roller at the negative x end. It shortens the contact length."""
    bReCorRad2: float
    """Record 5B.1 [m]. Corner radius of the roller at the positive x end. It shortens the contact length."""
    raceLandLmt1: float
    """Record 5B.2 [m]. Usable width of the outer raceway along the roller, without undercuts."""
    raceCenLen1: float
    """Record 5B.2 [m]. Width of the flat land in the middle of a crowned outer raceway. It is used only with a
    crown."""
    raceCrn1: float
    """Record 5B.2 [m]. Crown radius of the outer raceway on both sides of the flat land; 0 means no crown. The crown
    curves away from the rollers."""
    raceLandLmt2: float
    """Record 5B.2 [m]. Usable width of the inner raceway along the roller, without undercuts."""
    raceCenLen2: float
    """Record 5B.2 [m]. Width of the flat land in the middle of a crowned inner raceway. It is used only with a
    crown."""
    raceCrn2: float
    """Record 5B.2 [m]. Crown radius of the inner raceway on both sides of the flat land; 0 means no crown. The crown
    curves away from the rollers."""
    bReEndRad1: float
    """Record 5D.1 [m]. Sphere radius of the large end of the roller. This end can touch a flange."""
    bReEndRad2: float
    """Record 5D.1 [m]. Sphere radius of the small end of the roller. This end can touch a flange."""
    raceTaper1: float
    """Record 5D.1 [deg]. Half cone angle of the outer race. The cones of both races have a common apex. The pitch
    diameter follows from the two cone angles."""
    raceTaper2: float
    """Record 5D.1 [deg]. Half cone angle of the inner race. The cones of both races have a common apex. The pitch
    diameter follows from the two cone angles."""
    flngAng11: float
    """Record 5F [deg]. Layback angle of the flange on the outer race, negative x side; used when kFlngInd11 is 1."""
    flngAng21: float
    """Record 5F [deg]. Layback angle of the flange on the outer race, positive x side; used when kFlngInd21 is 1."""
    flngAng12: float
    """Record 5F [deg]. Layback angle of the flange on the inner race, negative x side; used when kFlngInd12 is 1."""
    flngAng22: float
    """Record 5F [deg]. Layback angle of the flange on the inner race, positive x side; used when kFlngInd22 is 1."""
    flngHt11: float
    """Record 5F [m]. Height of the flange on the outer race, negative x side; used when kFlngInd11 is 1."""
    flngHt21: float
    """Record 5F [m]. Height of the flange on the outer race, positive x side; used when kFlngInd21 is 1."""
    flngHt12: float
    """Record 5F [m]. Height of the flange on the inner race, negative x side; used when kFlngInd12 is 1."""
    flngHt22: float
    """Record 5F [m]. Height of the flange on the inner race, positive x side; used when kFlngInd22 is 1."""
    flngCls1: float
    """Record 5F [m]. Total free axial travel of a roller between the two flanges of the outer race; used if
    kFlngInd11 and kFlngInd21 are both 1."""
    flngCls2: float
    """Record 5F [m]. Total free axial travel of a roller between the two flanges of the inner race; used if
    kFlngInd12 and kFlngInd22 are both 1."""
    reDiaVar: float
    """Record 5G.1A [m]. Root-mean-square deviation of the ball diameters. The random numbers have a fixed seed."""
    reCrnVar: float
    """Record 5G.1B [m]. Root-mean-square deviation of the crown radii."""
    reLenVar: float
    """Record 5G.1B [m]. Root-mean-square deviation of the roller lengths."""
    reCLVar: float
    """Record 5G.1B [m]. Root-mean-square deviation of the lengths of the central lands of the rollers."""
    reCLOffset: float
    """Record 5G.1B [m]. Root-mean-square axial offset of the central lands of the rollers."""
    reDiaVar1: float
    """Record 5G.1D.1 [m]. Diameter of rolling element 1 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar2: float
    """Record 5G.1D.1 [m]. Diameter of rolling element 2 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar3: float
    """Record 5G.1D.1 [m]. Diameter of rolling element 3 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar4: float
    """Record 5G.1D.1 [m]. Diameter of rolling element 4 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar5: float
    """Record 5G.1D.1 [m]. Diameter of rolling element 5 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar6: float
    """Record 5G.1D.1 [m]. Diameter of rolling element 6 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar7: float
    """Record 5G.1D.1 [m]. Diameter of rolling element 7 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar8: float
    """Record 5G.1D.1 [m]. Diameter of rolling element 8 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar9: float
    """Record 5G.1D.1 [m]. Diameter of rolling element 9 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar10: float
    """Record 5G.1D.1 [m]. Diameter of rolling element 10 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar11: float
    """Record 5G.1D.2 [m]. Diameter of rolling element 11 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar12: float
    """Record 5G.1D.2 [m]. Diameter of rolling element 12 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar13: float
    """Record 5G.1D.2 [m]. Diameter of rolling element 13 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar14: float
    """Record 5G.1D.2 [m]. Diameter of rolling element 14 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar15: float
    """Record 5G.1D.2 [m]. Diameter of rolling element 15 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar16: float
    """Record 5G.1D.2 [m]. Diameter of rolling element 16 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar17: float
    """Record 5G.1D.2 [m]. Diameter of rolling element 17 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar18: float
    """Record 5G.1D.2 [m]. Diameter of rolling element 18 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar19: float
    """Record 5G.1D.2 [m]. Diameter of rolling element 19 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar20: float
    """Record 5G.1D.2 [m]. Diameter of rolling element 20 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar21: float
    """Record 5G.1D.3 [m]. Diameter of rolling element 21 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar22: float
    """Record 5G.1D.3 [m]. Diameter of rolling element 22 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar23: float
    """Record 5G.1D.3 [m]. Diameter of rolling element 23 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar24: float
    """Record 5G.1D.3 [m]. Diameter of rolling element 24 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar25: float
    """Record 5G.1D.3 [m]. Diameter of rolling element 25 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar26: float
    """Record 5G.1D.3 [m]. Diameter of rolling element 26 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar27: float
    """Record 5G.1D.3 [m]. Diameter of rolling element 27 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar28: float
    """Record 5G.1D.3 [m]. Diameter of rolling element 28 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar29: float
    """Record 5G.1D.3 [m]. Diameter of rolling element 29 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar30: float
    """Record 5G.1D.3 [m]. Diameter of rolling element 30 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar31: float
    """Record 5G.1D.4 [m]. Diameter of rolling element 31 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar32: float
    """Record 5G.1D.4 [m]. Diameter of rolling element 32 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar33: float
    """Record 5G.1D.4 [m]. Diameter of rolling element 33 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar34: float
    """Record 5G.1D.4 [m]. Diameter of rolling element 34 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar35: float
    """Record 5G.1D.4 [m]. Diameter of rolling element 35 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar36: float
    """Record 5G.1D.4 [m]. Diameter of rolling element 36 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar37: float
    """Record 5G.1D.4 [m]. Diameter of rolling element 37 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar38: float
    """Record 5G.1D.4 [m]. Diameter of rolling element 38 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar39: float
    """Record 5G.1D.4 [m]. Diameter of rolling element 39 minus the nominal diameter; 0 if there is no such element."""
    reDiaVar40: float
    """Record 5G.1D.4 [m]. Diameter of rolling element 40 minus the nominal diameter; 0 if there is no such element."""
    rndVar11: float
    """Record 5G.2.1A [m]. Semi-major axis minus nominal radius of the outer race."""
    rndVar21: float
    """Record 5G.2.1A [m]. Semi-minor axis minus nominal radius of the outer race."""
    rndVar31: float
    """Record 5G.2.1A [deg]. Angle of the major axis of the elliptical race, measured from the race-fixed z axis and
    positive about x."""
    cFacVar11: float
    """Record 5G.2.1A. Amplitude a of the error of the curvature factor of the outer race, a sin(w theta + phi)."""
    cFacVar21: float
    """Record 5G.2.1A [cycle/rev]. Number w of waves per revolution of the error of the curvature factor of the outer
    race."""
    cFacVar31: float
    """Record 5G.2.1A [deg]. Phase phi of the error of the curvature factor of the outer race."""
    rlOffset11: float
    """Record 5G.2.1C [m]. Amplitude a of the axial offset of the land of the outer race, a sin(w theta + phi)."""
    rlOffset21: float
    """Record 5G.2.1C [cycle/rev]. Number w of waves per revolution of the axial offset of the land of the outer
    race."""
    rlOffset31: float
    """Record 5G.2.1C [deg]. Phase phi of the axial offset of the land of the outer race."""
    rlTaper11: float
    """Record 5G.2.1C [rad]. Amplitude a of the taper of the land of the outer race, a sin(w theta + phi)."""
    rlTaper21: float
    """Record 5G.2.1C [cycle/rev]. Number w of waves per revolution of the taper of the land of the outer race."""
    rlTaper31: float
    """Record 5G.2.1C [deg]. Phase phi of the taper of the land of the outer race."""
    rndVar12: float
    """Record 5G.2.2A [m]. Semi-major axis minus nominal radius of the inner race."""
    rndVar22: float
    """Record 5G.2.2A [m]. Semi-minor axis minus nominal radius of the inner race."""
    rndVar32: float
    """Record 5G.2.2A [deg]. Angle of the major axis of the elliptical race, measured from the race-fixed z axis and
    positive about x."""
    cFacVar12: float
    """Record 5G.2.2A. Amplitude a of the error of the curvature factor of the inner race, a sin(w theta + phi)."""
    cFacVar22: float
    """Record 5G.2.2A [cycle/rev]. Number w of waves per revolution of the error of the curvature factor of the inner
    race."""
    cFacVar32: float
    """Record 5G.2.2A [deg]. Phase phi of the error of the curvature factor of the inner race."""
    rlOffset12: float
    """Record 5G.2.2C [m]. Amplitude a of the axial offset of the land of the inner race, a sin(w theta + phi)."""
    rlOffset22: float
    """Record 5G.2.2C [cycle/rev]. Number w of waves per revolution of the axial offset of the land of the inner
    race."""
    rlOffset32: float
    """Record 5G.2.2C [deg]. Phase phi of the axial offset of the land of the inner race."""
    rlTaper12: float
    """Record 5G.2.2C [rad]. Amplitude a of the taper of the land of the inner race, a sin(w theta + phi)."""
    rlTaper22: float
    """Record 5G.2.2C [cycle/rev]. Number w of waves per revolution of the taper of the land of the inner race."""
    rlTaper32: float
    """Record 5G.2.2C [deg]. Phase phi of the taper of the land of the inner race."""
    bReMass: float
    """Record 6.1 [kg]. Mass of the rolling element."""
    bReMIx: float
    """Record 6.1 [kg.m^2]. Principal moment of inertia of the rolling element about its polar x axis."""
    bReMIy: float
    """Record 6.1 [kg.m^2]. Principal moment of inertia of the rolling element about its transverse y axis."""
    bReMIz: float
    """Record 6.1 [kg.m^2]. Principal moment of inertia of the rolling element about its transverse z axis."""
    bReGeoCenX: float
    """Record 6.1 [m]. X component of the vector from the mass center to the geometric center of the rolling element,
    in its geometric frame. Enter 0 for a balanced body."""
    bReGeoCenY: float
    """Record 6.1 [m]. Y component of the vector from the mass center to the geometric center of the rolling element,
    in its geometric frame. Enter 0 for a balanced body."""
    bReGeoCenZ: float
    """Record 6.1 [m]. Z component of the vector from the mass center to the geometric center of the rolling element,
    in its geometric frame. Enter 0 for a balanced body."""
    bReFrameX: float
    """Record 6.1 [deg]. Rotation angle about X from the principal axes of inertia to the geometric frame of the
    rolling element. Enter 0 if both coincide."""
    bReFrameY: float
    """Record 6.1 [deg]. Rotation angle about Y from the principal axes of inertia to the geometric frame of the
    rolling element. Enter 0 if both coincide."""
    bReFrameZ: float
    """Record 6.1 [deg]. Rotation angle about Z from the principal axes of inertia to the geometric frame of the
    rolling element. Enter 0 if both coincide."""
    raceMass1: float
    """Record 6.2.1 [kg]. Mass of the outer race."""
    raceMIx1: float
    """Record 6.2.1 [kg.m^2]. Principal moment of inertia of the outer race about its polar x axis."""
    raceMIy1: float
    """Record 6.2.1 [kg.m^2]. Principal moment of inertia of the outer race about its transverse y axis."""
    raceMIz1: float
    """Record 6.2.1 [kg.m^2]. Principal moment of inertia of the outer race about its transverse z axis."""
    raceGeoCenX1: float
    """Record 6.2.1 [m]. X component of the vector from the mass center to the geometric center of the outer race, in
    the race frame. Enter 0 for a balanced body."""
    raceGeoCenY1: float
    """Record 6.2.1 [m]. Y component of the vector from the mass center to the geometric center of the outer race, in
    the race frame. Enter 0 for a balanced body."""
    raceGeoCenZ1: float
    """Record 6.2.1 [m]. Z component of the vector from the mass center to the geometric center of the outer race, in
    the race frame. Enter 0 for a balanced body."""
    raceFrameX1: float
    """Record 6.2.1 [deg]. Rotation angle about X from the principal axes of inertia to the geometric frame of the
    outer race. Enter 0 if both coincide."""
    raceFrameY1: float
    """Record 6.2.1 [deg]. Rotation angle about Y from the principal axes of inertia to the geometric frame of the
    outer race. Enter 0 if both coincide."""
    raceFrameZ1: float
    """Record 6.2.1 [deg]. Rotation angle about Z from the principal axes of inertia to the geometric frame of the
    outer race. Enter 0 if both coincide."""
    raceMass2: float
    """Record 6.2.2 [kg]. Mass of the inner race."""
    raceMIx2: float
    """Record 6.2.2 [kg.m^2]. Principal moment of inertia of the inner race about its polar x axis."""
    raceMIy2: float
    """Record 6.2.2 [kg.m^2]. Principal moment of inertia of the inner race about its transverse y axis."""
    raceMIz2: float
    """Record 6.2.2 [kg.m^2]. Principal moment of inertia of the inner race about its transverse z axis."""
    raceGeoCenX2: float
    """Record 6.2.2 [m]. X component of the vector from the mass center to the geometric center of the inner race, in
    the race frame. Enter 0 for a balanced body."""
    raceGeoCenY2: float
    """Record 6.2.2 [m]. Y component of the vector from the mass center to the geometric center of the inner race, in
    the race frame. Enter 0 for a balanced body."""
    raceGeoCenZ2: float
    """Record 6.2.2 [m]. Z component of the vector from the mass center to the geometric center of the inner race, in
    the race frame. Enter 0 for a balanced body."""
    raceFrameX2: float
    """Record 6.2.2 [deg]. Rotation angle about X from the principal axes of inertia to the geometric frame of the
    inner race. Enter 0 if both coincide."""
    raceFrameY2: float
    """Record 6.2.2 [deg]. Rotation angle about Y from the principal axes of inertia to the geometric frame of the
    inner race. Enter 0 if both coincide."""
    raceFrameZ2: float
    """Record 6.2.2 [deg]. Rotation angle about Z from the principal axes of inertia to the geometric frame of the
    inner race. Enter 0 if both coincide."""
    kPocType: int
    """Record 7.0. Shape of the pockets. The meaning of a code depends on the bearing type (kBrg). For rollers, a
    positive value is the number of guide surface pairs on records 7.3.i."""
    kCagePocImp: int
    """Record 7.0. Geometry errors of the pockets."""
    kCageGsImp: int
    """Record 7.0. Geometry errors of the guide lands of the cage. The code is used only if nGL (number of guide
    lands) is above 0."""
    kRaceGsImp: int
    """Record 7.0. Geometry errors of the guide lands of the race. The code is used only if nGL (number of guide
    lands) is above 0."""
    kPocHydro: int
    """Record 7.0. Hydrodynamic forces of the oil film in the pockets. They are not available with a segmented cage."""
    kGsHydro: int
    """Record 7.0. Hydrodynamic forces of the oil film at the guide lands. They are not available with a segmented
    cage."""
    kCageMat: int
    """Record 7.0. Material of the cage. 0 is mild steel, and 1 takes the properties from the deck. The material
    table lists the other codes."""
    kCageIP: int
    """Record 7.0. Source of mass and inertia of the cage."""
    nGL: int
    """Record 7.0. Number of cage lands that are guided by a race, at most 4; 0 for none."""
    iCageGuide: np.ndarray
    """Record 7.0. Race that guides each land of the cage."""
    lSeg: np.ndarray
    """Record 7.0.1. Number of the first rolling element of each cage segment, in increasing absolute values. With a
    positive number, the cage is cut just before this element. With a negative number, the cage is cut through the
    pocket of this element."""
    cageDia1: float
    """Record 7.1 [m]. Outer diameter of the cage."""
    cageDia2: float
    """Record 7.1 [m]. Inner diameter of the cage."""
    cageWidth: float
    """Record 7.1 [m]. Width of the cage."""
    cageCls1: float
    """Record 7.1 [m]. Diametral clearance between cage and outer race outside the guide lands. The clearances of the
    lands are on records 7.2.i."""
    cageCls2: float
    """Record 7.1 [m]. Diametral clearance between cage and inner race outside the guide lands. The clearances of the
    lands are on records 7.2.i."""
    bPocCls1: float
    """Record 7.1 [m]. Pocket clearance I: circumferential pocket size minus element diameter. For elongated ball
    pockets, it is the axial clearance. For conical ball pockets, it is the inner opening minus the ball diameter.
    It is not used for roller pockets with guide surface pairs."""
    bPocCls2: float
    """Record 7.1 [m]. Pocket clearance II of ball pockets. Elongated pocket: center offset. Rectangular pocket:
    axial clearance. Conical pocket: outer opening minus ball diameter. Enter 0 for other ball pockets and for
    rollers."""
    cageAngCut: float
    """Record 7.1 [deg]. Angular width of the cut between two cage segments; 0 for a one-piece cage."""
    cageConeAng: float
    """Record 7.1 [deg]. Half cone angle of a conical cage; 0 for a cylindrical cage."""
    cageGsDia: np.ndarray
    """Record 7.2.i [m]. Diameter of the guide land of the cage."""
    cageGsWidth: np.ndarray
    """Record 7.2.i [m]. Width of the guide land."""
    cageGsPos: np.ndarray
    """Record 7.2.i [m]. Axial distance from the cage center to the outer edge of the guide land. It is negative for
    a land on the negative x side."""
    cageGsCls: np.ndarray
    """Record 7.2.i [m]. Diametral clearance between the guide land of the cage and the race that guides the cage."""
    bPocGsAng1: np.ndarray
    """Record 7.3.i [deg]. Rotation about x from the pocket frame to the frame of the guide surface."""
    bPocGsAng2: np.ndarray
    """Record 7.3.i [deg]. Rotation about y from the pocket frame to the frame of the guide surface."""
    bPocGsAng3: np.ndarray
    """Record 7.3.i [deg]. Rotation about z from the pocket frame to the frame of the guide surface."""
    bPocGsCen1: np.ndarray
    """Record 7.3.i [m]. x coordinate of the center of the guide surface, measured from the pocket center."""
    bPocGsCen2: np.ndarray
    """Record 7.3.i [m]. y coordinate of the center of the guide surface on the positive y side, measured from the
    pocket center. The second surface of the pair is its mirror image in the x-z plane of the pocket."""
    bPocGsCen3: np.ndarray
    """Record 7.3.i [m]. z coordinate of the center of the guide surface, measured from the pocket center."""
    bPocGsLen1: np.ndarray
    """Record 7.3.i [m]. Width of the guide surface (along z)."""
    bPocGsLen2: np.ndarray
    """Record 7.3.i [m]. Length of the guide surface (along x)."""
    bPocClsVar1: float
    """Record 7.4 [m]. Deviation of pocket clearance I from its nominal value (bPocCls1). If kCagePocImp is 3
    (random), enter the rms value of the deviation."""
    bPocClsVar2: float
    """Record 7.4 [m]. Deviation of pocket clearance II from its nominal value (bPocCls2). If kCagePocImp is 3
    (random), enter the rms value of the deviation."""
    bPocThknsVar: float
    """Record 7.4 [m]. Deviation of the pocket thickness from the cage thickness (outer minus inner cage radius)."""
    bPocCenVar1: float
    """Record 7.4 [m]. Axial shift of the pocket center."""
    bPocCenVar2: float
    """Record 7.4 [deg]. Angular shift of the pocket center along the pitch circle."""
    bPocAngVar1: float
    """Record 7.4 [deg]. Tilt of the pocket frame, first angle (about x)."""
    bPocAngVar2: float
    """Record 7.4 [deg]. Tilt of the pocket frame, second angle (about the y axis after the first rotation)."""
    bPocAngVar3: float
    """Record 7.4 [deg]. Tilt of the pocket frame, third angle (about the z axis after both rotations)."""
    cageGsRadVar1: np.ndarray
    """Record 7.5.i [m]. Cage guide land: if kCageGsImp is 1, semi-axis along y minus nominal radius; if kCageGsImp
    is 2, amplitude of the radius wave."""
    cageGsRadVar2: np.ndarray
    """Record 7.5.i [m]. Cage guide land: if kCageGsImp is 1, semi-axis along z minus nominal radius; if kCageGsImp
    is 2, number of waves per revolution (no unit)."""
    cageGsRadVar3: np.ndarray
    """Record 7.5.i [deg]. Cage guide land: phase of the radius wave if kCageGsImp is 2. If kCageGsImp is 1, the
    value is not used; enter 0."""
    raceGsRadVar1: np.ndarray
    """Record 7.6.i [m]. Race guide land: if kRaceGsImp is 1, semi-axis along y minus nominal radius; if kRaceGsImp
    is 2, amplitude of the radius wave."""
    raceGsRadVar2: np.ndarray
    """Record 7.6.i [m]. Race guide land: if kRaceGsImp is 1, semi-axis along z minus nominal radius; if kRaceGsImp
    is 2, number of waves per revolution (no unit)."""
    raceGsRadVar3: np.ndarray
    """Record 7.6.i [deg]. Race guide land: phase of the radius wave if kRaceGsImp is 2. If kRaceGsImp is 1, the
    value is not used; enter 0."""
    cageMass: float
    """Record 7.7 [kg]. Mass of the cage."""
    cageMIx: float
    """Record 7.7 [kg.m^2]. Principal moment of inertia of the cage about its polar x axis."""
    cageMIy: float
    """Record 7.7 [kg.m^2]. Principal moment of inertia of the cage about its transverse y axis."""
    cageMIz: float
    """Record 7.7 [kg.m^2]. Principal moment of inertia of the cage about its transverse z axis."""
    cageGeoCenX: float
    """Record 7.7 [m]. X component of the vector from the mass center to the geometric center of the cage, in the
    cage frame. Enter 0 for a balanced body."""
    cageGeoCenY: float
    """Record 7.7 [m]. Y component of the vector from the mass center to the geometric center of the cage, in the
    cage frame. Enter 0 for a balanced body."""
    cageGeoCenZ: float
    """Record 7.7 [m]. Z component of the vector from the mass center to the geometric center of the cage, in the
    cage frame. Enter 0 for a balanced body."""
    cageFrameX: float
    """Record 7.7 [deg]. Rotation angle about X from the principal axes of inertia to the geometric frame of the
    cage. Enter 0 if both coincide."""
    cageFrameY: float
    """Record 7.7 [deg]. Rotation angle about Y from the principal axes of inertia to the geometric frame of the
    cage. Enter 0 if both coincide."""
    cageFrameZ: float
    """Record 7.7 [deg]. Rotation angle about Z from the principal axes of inertia to the geometric frame of the
    cage. Enter 0 if both coincide."""
    reDen: float
    """Record 8.1 [kg/m^3]. Density of the rolling elements."""
    reEM: float
    """Record 8.1 [N/m^2]. Elastic (Young's) modulus of the rolling elements."""
    rePR: float
    """Record 8.1. Poisson ratio of the rolling elements. About 0.3 for metals."""
    reCTE: float
    """Record 8.1 [1/K]. Linear thermal expansion coefficient of the rolling elements."""
    reTC: float
    """Record 8.1 [W/m/K]. Thermal conductivity of the rolling elements."""
    reSH: float
    """Record 8.1 [J/kg/K]. Specific heat of the rolling elements."""
    reESL: float
    """Record 8.1. Elastic strain limit of the rolling elements. Strains above this limit are reported as plastic."""
    reH: float
    """Record 8.1 [HRC]. Rockwell C hardness of the rolling elements. The indentation pressure of the wear law is
    computed from this hardness."""
    reWC: float
    """Record 8.1. Wear coefficient K of the rolling elements. The worn volume is K times load times sliding
    distance, divided by hardness."""
    reVM: float
    """Record 8.1 [N/m^2]. Von Mises fatigue limit stress of the rolling elements. Below this stress the Ioannides-
    Harris life is infinite."""
    raceDen1: float
    """Record 8.2.1 [kg/m^3]. Density of the outer race."""
    raceEM1: float
    """Record 8.2.1 [N/m^2]. Elastic (Young's) modulus of the outer race."""
    racePR1: float
    """Record 8.2.1. Poisson ratio of the outer race. About 0.3 for metals."""
    raceCTE1: float
    """Record 8.2.1 [1/K]. Linear thermal expansion coefficient of the outer race."""
    raceTC1: float
    """Record 8.2.1 [W/m/K]. Thermal conductivity of the outer race."""
    raceSH1: float
    """Record 8.2.1 [J/kg/K]. Specific heat of the outer race."""
    raceESL1: float
    """Record 8.2.1. Elastic strain limit of the outer race. Strains above this limit are reported as plastic."""
    raceH1: float
    """Record 8.2.1 [HRC]. Rockwell C hardness of the outer race. The indentation pressure of the wear law is
    computed from this hardness."""
    raceWC1: float
    """Record 8.2.1. Wear coefficient K of the outer race. The worn volume is K times load times sliding distance,
    divided by hardness."""
    raceVM1: float
    """Record 8.2.1 [N/m^2]. Von Mises fatigue limit stress of the outer race. Below this stress the Ioannides-Harris
    life is infinite."""
    raceDen2: float
    """Record 8.2.2 [kg/m^3]. Density of the inner race."""
    raceEM2: float
    """Record 8.2.2 [N/m^2]. Elastic (Young's) modulus of the inner race."""
    racePR2: float
    """Record 8.2.2. Poisson ratio of the inner race. About 0.3 for metals."""
    raceCTE2: float
    """Record 8.2.2 [1/K]. Linear thermal expansion coefficient of the inner race."""
    raceTC2: float
    """Record 8.2.2 [W/m/K]. Thermal conductivity of the inner race."""
    raceSH2: float
    """Record 8.2.2 [J/kg/K]. Specific heat of the inner race."""
    raceESL2: float
    """Record 8.2.2. Elastic strain limit of the inner race. Strains above this limit are reported as plastic."""
    raceH2: float
    """Record 8.2.2 [HRC]. Rockwell C hardness of the inner race. The indentation pressure of the wear law is
    computed from this hardness."""
    raceWC2: float
    """Record 8.2.2. Wear coefficient K of the inner race. The worn volume is K times load times sliding distance,
    divided by hardness."""
    raceVM2: float
    """Record 8.2.2 [N/m^2]. Von Mises fatigue limit stress of the inner race. Below this stress the Ioannides-Harris
    life is infinite."""
    shftDen: float
    """Record 8.3 [kg/m^3]. Density of the shaft."""
    shftEM: float
    """Record 8.3 [N/m^2]. Elastic (Young's) modulus of the shaft."""
    shftPR: float
    """Record 8.3. Poisson ratio of the shaft. About 0.3 for metals."""
    shftCTE: float
    """Record 8.3 [1/K]. Linear thermal expansion coefficient of the shaft."""
    shftTC: float
    """Record 8.3 [W/m/K]. Thermal conductivity of the shaft."""
    hsngDen: float
    """Record 8.4 [kg/m^3]. Density of the housing."""
    hsngEM: float
    """Record 8.4 [N/m^2]. Elastic (Young's) modulus of the housing."""
    hsngPR: float
    """Record 8.4. Poisson ratio of the housing. About 0.3 for metals."""
    hsngCTE: float
    """Record 8.4 [1/K]. Linear thermal expansion coefficient of the housing."""
    hsngTC: float
    """Record 8.4 [W/m/K]. Thermal conductivity of the housing."""
    cageDen: float
    """Record 8.5 [kg/m^3]. Density of the cage."""
    cageEM: float
    """Record 8.5 [N/m^2]. Elastic (Young's) modulus of the cage."""
    cagePR: float
    """Record 8.5. Poisson ratio of the cage. About 0.3 for metals."""
    cageCTE: float
    """Record 8.5 [1/K]. Linear thermal expansion coefficient of the cage."""
    cageTC: float
    """Record 8.5 [W/m/K]. Thermal conductivity of the cage."""
    cageSH: float
    """Record 8.5 [J/kg/K]. Specific heat of the cage."""
    cageESL: float
    """Record 8.5. Elastic strain limit of the cage. Strains above this limit are reported as plastic."""
    cageH: float
    """Record 8.5 [HRC]. Rockwell C hardness of the cage. The indentation pressure of the wear law is computed from
    this hardness."""
    cageWC: float
    """Record 8.5. Wear coefficient K of the cage. The worn volume is K times load times sliding distance, divided by
    hardness."""
    sProb: float
    """Record 8.6.0. Survival probability for which the life is computed; 0.9 gives L10."""
    brgWbDis: float
    """Record 8.6.0. Weibull slope of the bearing as a whole."""
    fco1: float
    """Record 8.6.1. Multiplier on the constant of the original Lundberg-Palmgren model, outer race. 1 keeps the
    built-in value."""
    fcLP1: float
    """Record 8.6.1. Multiplier on the constant of the updated Lundberg-Palmgren model, outer race. 1 keeps the
    built-in value."""
    shExLP1: float
    """Record 8.6.1. Shear stress exponent of the updated Lundberg-Palmgren model, outer race. 0 selects the built-in
    value."""
    depExLP1: float
    """Record 8.6.1. Depth exponent of the updated Lundberg-Palmgren model, outer race. 0 selects the built-in value
    if the shear stress exponent is also 0."""
    fcGZ1: float
    """Record 8.6.1. Multiplier on the constant of the Gupta-Zaretsky model, outer race. 1 keeps the built-in value."""
    shExGZ1: float
    """Record 8.6.1. Shear stress exponent of the Gupta-Zaretsky model, outer race. 0 selects the built-in value."""
    fcIH1: float
    """Record 8.6.1. Multiplier on the constant of the updated Ioannides-Harris model, outer race. 1 keeps the built-
    in value."""
    shExIH1: float
    """Record 8.6.1. Shear stress exponent of the updated Ioannides-Harris model, outer race. 0 selects the built-in
    value."""
    depExIH1: float
    """Record 8.6.1. Depth exponent of the updated Ioannides-Harris model, outer race. 0 selects the built-in value
    if the shear stress exponent is also 0."""
    wbDis1: float
    """Record 8.6.1. Weibull slope of the outer race."""
    fco2: float
    """Record 8.6.2. Multiplier on the constant of the original Lundberg-Palmgren model, inner race. 1 keeps the
    built-in value."""
    fcLP2: float
    """Record 8.6.2. Multiplier on the constant of the updated Lundberg-Palmgren model, inner race. 1 keeps the
    built-in value."""
    shExLP2: float
    """Record 8.6.2. Shear stress exponent of the updated Lundberg-Palmgren model, inner race. 0 selects the built-in
    value."""
    depExLP2: float
    """Record 8.6.2. Depth exponent of the updated Lundberg-Palmgren model, inner race. 0 selects the built-in value
    if the shear stress exponent is also 0."""
    fcGZ2: float
    """Record 8.6.2. Multiplier on the constant of the Gupta-Zaretsky model, inner race. 1 keeps the built-in value."""
    shExGZ2: float
    """Record 8.6.2. Shear stress exponent of the Gupta-Zaretsky model, inner race. 0 selects the built-in value."""
    fcIH2: float
    """Record 8.6.2. Multiplier on the constant of the updated Ioannides-Harris model, inner race. 1 keeps the built-
    in value."""
    shExIH2: float
    """Record 8.6.2. Shear stress exponent of the updated Ioannides-Harris model, inner race. 0 selects the built-in
    value."""
    depExIH2: float
    """Record 8.6.2. Depth exponent of the updated Ioannides-Harris model, inner race. 0 selects the built-in value
    if the shear stress exponent is also 0."""
    wbDis2: float
    """Record 8.6.2. Weibull slope of the inner race."""
    fcLPre: float
    """Record 8.6.3. Multiplier on the constant of the updated Lundberg-Palmgren model, rolling elements. 1 keeps the
    built-in value."""
    shExLPre: float
    """Record 8.6.3. Shear stress exponent of the updated Lundberg-Palmgren model, rolling elements. 0 selects the
    built-in value."""
    depExLPre: float
    """Record 8.6.3. Depth exponent of the updated Lundberg-Palmgren model, rolling elements. 0 selects the built-in
    value if the shear stress exponent is also 0."""
    fcGZre: float
    """Record 8.6.3. Multiplier on the constant of the Gupta-Zaretsky model, rolling elements. 1 keeps the built-in
    value."""
    shExGZre: float
    """Record 8.6.3. Shear stress exponent of the Gupta-Zaretsky model, rolling elements. 0 selects the built-in
    value."""
    fcIHre: float
    """Record 8.6.3. Multiplier on the constant of the updated Ioannides-Harris model, rolling elements. 1 keeps the
    built-in value."""
    shExIHre: float
    """Record 8.6.3. Shear stress exponent of the updated Ioannides-Harris model, rolling elements. 0 selects the
    built-in value."""
    depExIHre: float
    """Record 8.6.3. Depth exponent of the updated Ioannides-Harris model, rolling elements. 0 selects the built-in
    value if the shear stress exponent is also 0."""
    wbDisRe: float
    """Record 8.6.3. Weibull slope of the rolling elements."""
    rmsAspSlope1: float
    """Record 8.6.4 [rad]. Composite rms asperity slope of the outer race contact, used in the Tallian life factors."""
    aspTrac1: float
    """Record 8.6.4. Asperity traction coefficient of the outer race contact, used in the Tallian life factors."""
    facMat1: float
    """Record 8.6.4. Tallian material factor, outer race. 1.197 for 52100, 1.773 for 8620, 2.267 for M50."""
    facCont1: float
    """Record 8.6.4. Tallian contamination factor, outer race. The standard value is 1. For VIMVAR steel in aerospace
    use, it is about 0.25 and can be as low as 0.10."""
    facProc1: float
    """Record 8.6.4. Tallian process factor, outer race. Published values: 2.58 for CVD steel before 1975, 0.077 for
    CVD steel since 1975, 4.85 for carburizing CVD steel, 0.003 to 0.0050 for VIMVAR steel. These values differ so
    much that they may be wrong. Check a value before you use it."""
    facMatLF1: float
    """Record 8.6.4. STLE material factor, outer race. 1 does not change the life."""
    facProcLF1: float
    """Record 8.6.4. STLE process factor, outer race. 1 does not change the life."""
    hardnessLF1: float
    """Record 8.6.4. STLE hardness factor, outer race. 1 does not change the life."""
    rmsAspSlope2: float
    """Record 8.6.5 [rad]. Composite rms asperity slope of the inner race contact, used in the Tallian life factors."""
    aspTrac2: float
    """Record 8.6.5. Asperity traction coefficient of the inner race contact, used in the Tallian life factors."""
    facMat2: float
    """Record 8.6.5. Tallian material factor, inner race. 1.197 for 52100, 1.773 for 8620, 2.267 for M50."""
    facCont2: float
    """Record 8.6.5. Tallian contamination factor, inner race. The standard value is 1. For VIMVAR steel in aerospace
    use, it is about 0.25 and can be as low as 0.10."""
    facProc2: float
    """Record 8.6.5. Tallian process factor, inner race. Published values: 2.58 for CVD steel before 1975, 0.077 for
    CVD steel since 1975, 4.85 for carburizing CVD steel, 0.003 to 0.0050 for VIMVAR steel. These values differ so
    much that they may be wrong. Check a value before you use it."""
    facMatLF2: float
    """Record 8.6.5. STLE material factor, inner race. 1 does not change the life."""
    facProcLF2: float
    """Record 8.6.5. STLE process factor, inner race. 1 does not change the life."""
    hardnessLF2: float
    """Record 8.6.5. STLE hardness factor, inner race. 1 does not change the life."""
    facMatRe: float
    """Record 8.6.6. Tallian material factor, rolling elements. 1.197 for 52100, 1.773 for 8620, 2.267 for M50."""
    facContRe: float
    """Record 8.6.6. Tallian contamination factor, rolling elements. The standard value is 1. For VIMVAR steel in
    aerospace use, it is about 0.25 and can be as low as 0.10."""
    facProcRe: float
    """Record 8.6.6. Tallian process factor, rolling elements. Published values: 2.58 for CVD steel before 1975,
    0.077 for CVD steel since 1975, 4.85 for carburizing CVD steel, 0.003 to 0.0050 for VIMVAR steel. These values
    differ so much that they may be wrong. Check a value before you use it."""
    facMatLFre: float
    """Record 8.6.6. STLE material factor, rolling elements. 1 does not change the life."""
    facProcLFre: float
    """Record 8.6.6. STLE process factor, rolling elements. 1 does not change the life."""
    hardnessLFre: float
    """Record 8.6.6. STLE hardness factor, rolling elements. 1 does not change the life."""
    roomTemp: float
    """Record 9.0 [K]. Room temperature (absolute), at which all dimensions and fits are given."""
    raceFit1: float
    """Record 9.0 [m]. Diametral fit of the outer race in the housing, mounted at room temperature; positive is
    interference."""
    raceFit2: float
    """Record 9.0 [m]. Diametral fit of the inner race on the shaft, mounted at room temperature; positive is
    interference."""
    angVelOrient: float
    """Record 9.0 [deg]. Angle between the ball spin axis and the x axis, in the plane through ball center and
    bearing axis, relative to the orbiting ball frame. It is used only when kAngVel is 2. With a positive angle,
    the end of the spin axis towards -x is tilted outwards. If the angle equals the contact angle, the ball rolls
    without spin. If the inner race rotates in the positive direction, the spin vector points to -x. The file
    PRINT.txt contains theta, the angle of the total angular velocity, which includes the orbit. Theta is slightly
    below 180 degrees minus the angle of the spin axis."""
    res1: float
    """Record 9.0 [N/m^2]. Residual stress of the outer race in operation, positive in tension. It enters the STLE
    life factor."""
    res2: float
    """Record 9.0 [N/m^2]. Residual stress of the inner race in operation, positive in tension. It enters the STLE
    life factor."""
    facStrLimit: float
    """Record 9.0. Multiplier on the fatigue limit stress. With 1, the limit is the octahedral shear stress at the
    von Mises limit stress of the race material. A multiplier of 1.28 reproduces ISO 281 for AISI 52100 steel."""
    appLoadX: float
    """Record 9.1.1 [N]. Force that the shaft applies to the inner race along x, used when kFS1 is 0."""
    appLoadY: float
    """Record 9.1.1 [N]. Force that the shaft applies to the inner race along y, used when kFS2 is 0."""
    appLoadZ: float
    """Record 9.1.1 [N]. Force that the shaft applies to the inner race along z, used when kFS3 is 0."""
    appDispX: float
    """Record 9.1.1 [m]. Displacement of the inner race relative to the outer race along x when kFS1 is 1. When kFS1
    is 0, it is the first guess of the static solution. If this guess is 0, the program estimates the first guess.
    The displacement is measured from the unmounted bearing at rest and at room temperature. At displacement 0,
    balls just touch both races at the contact angle freeConAng (towards +x), and tapered rollers just touch both
    races. In other bearings, the mid planes of the races coincide at displacement 0. Fits, thermal growth and
    speed do not change this reference position."""
    appDispY: float
    """Record 9.1.1 [m]. Displacement of the inner race relative to the outer race along y when kFS2 is 1. When kFS2
    is 0, it is the first guess of the static solution. If this guess is 0, the program estimates the first guess.
    The displacement is measured from the unmounted bearing at rest and at room temperature. At displacement 0,
    the races are coaxial. Fits, thermal growth and speed do not change this reference position."""
    appDispZ: float
    """Record 9.1.1 [m]. Displacement of the inner race relative to the outer race along z when kFS3 is 1. When kFS3
    is 0, it is the first guess of the static solution. If this guess is 0, the program estimates the first guess.
    The displacement is measured from the unmounted bearing at rest and at room temperature. At displacement 0,
    the races are coaxial. Fits, thermal growth and speed do not change this reference position."""
    appMomY: float
    """Record 9.1.2 [N.m]. Moment that the shaft applies to the inner race about y, used when kFS4 is 0."""
    appMomZ: float
    """Record 9.1.2 [N.m]. Moment that the shaft applies to the inner race about z, used when kFS5 is 0."""
    appMis11: float
    """Record 9.1.2 [rad]. Misalignment of the reference (outer) race about y."""
    appMis21: float
    """Record 9.1.2 [rad]. Misalignment of the reference (outer) race about z."""
    appMis12: float
    """Record 9.1.2 [rad]. Misalignment of the moving (inner) race about y when kFS4 is 1. When kFS4 is 0, it is the
    first guess of the static solution."""
    appMis22: float
    """Record 9.1.2 [rad]. Misalignment of the moving (inner) race about z when kFS5 is 1. When kFS5 is 0, it is the
    first guess of the static solution."""
    rpm1: float
    """Record 9.1.2 [rpm]. Speed of the outer race, positive about x."""
    rpm2: float
    """Record 9.1.2 [rpm]. Speed of the inner race, positive about x."""
    hsngTemp: float
    """Record 9.1.3 [K]. Temperature (absolute) of the housing at the start. Thermal expansion is computed from the
    difference between this temperature and room temperature."""
    shftTemp: float
    """Record 9.1.3 [K]. Temperature (absolute) of the shaft at the start. Thermal expansion is computed from the
    difference between this temperature and room temperature."""
    raceTemp1: float
    """Record 9.1.3 [K]. Temperature (absolute) of the outer race at the start. Thermal expansion is computed from
    the difference between this temperature and room temperature."""
    raceTemp2: float
    """Record 9.1.3 [K]. Temperature (absolute) of the inner race at the start. Thermal expansion is computed from
    the difference between this temperature and room temperature."""
    reTemp: float
    """Record 9.1.3 [K]. Temperature (absolute) of the rolling elements at the start. Thermal expansion is computed
    from the difference between this temperature and room temperature."""
    cageTemp: float
    """Record 9.1.3 [K]. Temperature (absolute) of the cage at the start. Thermal expansion is computed from the
    difference between this temperature and room temperature."""
    pctDisp: float
    """Record 9.2 [%]. Displacement increment for computing the stiffness, in percent of the contact deflection."""
    rpmRange11: float
    """Record 9.2 [rpm]. First speed of the outer race in the stiffness table."""
    rpmRange21: float
    """Record 9.2 [rpm]. Last speed of the outer race in the stiffness table."""
    rpmRange12: float
    """Record 9.2 [rpm]. First speed of the inner race in the stiffness table."""
    rpmRange22: float
    """Record 9.2 [rpm]. Last speed of the inner race in the stiffness table."""
    rotLoadFrac1: float
    """Record 9.3A. Orbit radius of the outer race divided by the radial deflection between the races."""
    rotLoadFrac2: float
    """Record 9.3A. Orbit radius of the inner race divided by the radial deflection between the races."""
    rotLoadRpm1: float
    """Record 9.3A [rpm]. Rotational speed of the load due to the orbit of the outer race."""
    rotLoadRpm2: float
    """Record 9.3A [rpm]. Rotational speed of the load due to the orbit of the inner race."""
    raceVibAmp11: float
    """Record 9.3B [m]. Outer race: amplitude A of the motion A sin(2 pi f t) along x."""
    raceVibAmp21: float
    """Record 9.3B [m]. Outer race: amplitude A of the motion A sin(2 pi f t) along y."""
    raceVibAmp31: float
    """Record 9.3B [m]. Outer race: amplitude A of the motion A sin(2 pi f t) along z."""
    raceVibAmp12: float
    """Record 9.3B [m]. Inner race: amplitude A of the motion A sin(2 pi f t) along x."""
    raceVibAmp22: float
    """Record 9.3B [m]. Inner race: amplitude A of the motion A sin(2 pi f t) along y."""
    raceVibAmp32: float
    """Record 9.3B [m]. Inner race: amplitude A of the motion A sin(2 pi f t) along z."""
    raceVibFreq1: float
    """Record 9.3B [Hz]. Outer race: frequency f of the motion."""
    raceVibFreq2: float
    """Record 9.3B [Hz]. Inner race: frequency f of the motion."""
    raceAngAcc1: float
    """Record 9.4A [rpm/s]. Angular acceleration of the outer race."""
    raceAngAcc2: float
    """Record 9.4A [rpm/s]. Angular acceleration of the inner race."""
    startTime1: float
    """Record 9.4A [s]. Time at which the outer race starts to accelerate."""
    endTime1: float
    """Record 9.4A [s]. Time at which the outer race stops accelerating."""
    startTime2: float
    """Record 9.4A [s]. Time at which the inner race starts to accelerate."""
    endTime2: float
    """Record 9.4A [s]. Time at which the inner race stops accelerating."""
    raceSpeedAmp1: float
    """Record 9.4B [rpm]. Amplitude A of the sinusoidal part of the outer race speed, rpm1 + A sin(2 pi f t)."""
    raceSpeedAmp2: float
    """Record 9.4B [rpm]. Amplitude A of the sinusoidal part of the inner race speed, rpm2 + A sin(2 pi f t)."""
    raceSpeedFreq1: float
    """Record 9.4B [Hz]. Frequency f of the sinusoidal part of the outer race speed."""
    raceSpeedFreq2: float
    """Record 9.4B [Hz]. Frequency f of the sinusoidal part of the inner race speed."""
    brgOrbitRad: float
    """Record 9.5 [m]. Orbit radius of the bearing center."""
    brgAngPos: float
    """Record 9.5 [deg]. Angle of the bearing center on its orbit at the start."""
    brgAngVel: float
    """Record 9.5 [rpm]. Orbit speed of the bearing center."""
    brgLoadFrac1: float
    """Record 9.5. Fraction of the inertia load of the outer race that the bearing carries."""
    brgLoadFrac2: float
    """Record 9.5. Fraction of the inertia load of the inner race that the bearing carries."""
    pocLubFilm: float
    """Record 9.6 [m]. Largest thickness of the lubricant film in the pockets. The film acts on elements that are
    closer to the pocket wall than this thickness."""
    wvRatio: float
    """Record 9.6. Whirl speed of the cage mass center at the start, divided by the angular speed of the cage."""
    avRatio: float
    """Record 9.6. Angular speed of the cage at the start, divided by the epicyclic speed of the rolling elements."""
    cageGcPos: np.ndarray
    """Record 9.6 [m]. Coordinates x, y, z of the cage mass center at the start, relative to the center of the pitch
    circle."""
    cageAngPos: np.ndarray
    """Record 9.6 [deg]. Three angles of the transformation from the inertial frame to the frame of the cage at the
    start."""
    baseTemp: float
    """Record 9.7 [K]. Reference temperature (absolute) at the location selected by kBaseTemp."""
    cFlowRate: float
    """Record 9.7 [m^3/s]. Volume flow of the coolant; not used when kCoolant is 0."""
    reHTC: float
    """Record 9.7 [W/m^2/K]. Convection coefficient of the rolling elements. Enter 0 if the program computes it (kHTC
    = 0)."""
    cageHTC: float
    """Record 9.7 [W/m^2/K]. Convection coefficient of the cage. Enter 0 if the program computes it (kHTC = 0)."""
    aveTime: float
    """Record 9.7 [s]. Duration over which the heat is averaged for one thermal step (in seconds, not dimensionless)."""
    skipTime: float
    """Record 9.7 [s]. Duration of the first part of the run, in which the geometry is not updated for thermal
    expansion (in seconds, not dimensionless)."""
    xRo: float
    """Record 9.8 [kg/m^3]. Density of the coolant at base temperature."""
    xMu: float
    """Record 9.8 [N.s/m^2]. Viscosity of the coolant at base temperature."""
    xCp: float
    """Record 9.8 [J/kg/K]. Specific heat of the coolant."""
    xK: float
    """Record 9.8 [N/s/K]. Thermal conductivity of the coolant (N/s/K is the same unit as W/m/K)."""
    kTrac: int
    """Record 10.0. Traction model or lubricant between rolling elements and races."""
    kTracType: int
    """Record 10.0. Form of the hypothetical traction curve, element to race. The curve is always needed: it applies
    where the film is thinner than reRaceFilm."""
    kCPTrac: int
    """Record 10.0. Source of the traction coefficient, element to cage."""
    kCPTracType: int
    """Record 10.0. Form of the hypothetical traction curve, element to cage."""
    kCRTrac: int
    """Record 10.0. Source of the traction coefficient, cage to race."""
    kCRTracType: int
    """Record 10.0. Form of the hypothetical traction curve, cage to race."""
    kRFTrac: int
    """Record 10.0. Source of the traction coefficient, roller to flange."""
    kRFTracType: int
    """Record 10.0. Form of the hypothetical traction curve, roller to flange."""
    kRRTrac: int
    """Record 10.0. Source of the traction coefficient, element to element. It is used only if the bearing has no
    cage."""
    kRRTracType: int
    """Record 10.0. Form of the hypothetical traction curve, element to element. It is used only if the bearing has
    no cage."""
    iTherm: int
    """Record 10.0. Simplified thermal correction of the visco-elastic model. It is used only if kTrac is 12."""
    reRaceTC1: float
    """Record 10.1A. Coefficient A of the traction coefficient (A + B u) exp(-C u) + D at slip speed u, element to
    race."""
    reRaceTC2: float
    """Record 10.1A [s/m]. Coefficient B of the traction coefficient (A + B u) exp(-C u) + D at slip speed u, element
    to race."""
    reRaceTC3: float
    """Record 10.1A [s/m]. Coefficient C of the traction coefficient (A + B u) exp(-C u) + D at slip speed u, element
    to race."""
    reRaceTC4: float
    """Record 10.1A. Coefficient D (value at large slip) of the traction coefficient (A + B u) exp(-C u) + D at slip
    speed u, element to race."""
    reFlngTC1: float
    """Record 10.2A. Coefficient A of the traction coefficient (A + B u) exp(-C u) + D at slip speed u, roller to
    flange."""
    reFlngTC2: float
    """Record 10.2A [s/m]. Coefficient B of the traction coefficient (A + B u) exp(-C u) + D at slip speed u, roller
    to flange."""
    reFlngTC3: float
    """Record 10.2A [s/m]. Coefficient C of the traction coefficient (A + B u) exp(-C u) + D at slip speed u, roller
    to flange."""
    reFlngTC4: float
    """Record 10.2A. Coefficient D (value at large slip) of the traction coefficient (A + B u) exp(-C u) + D at slip
    speed u, roller to flange."""
    reRaceFilm: float
    """Record 10.3 [m]. Film thickness below which the hypothetical traction curve replaces the traction model of the
    lubricant."""
    strParam: float
    """Record 10.3. Distance of the oil meniscus from the contact edge divided by the contact half width. The contact
    is flooded at 10 or more, and heavily starved at 1 or less."""
    lubName: str
    """Record 10.4.0. Name of the lubricant, at most 36 characters; for documentation only."""
    refTemp: float
    """Record 10.4.1 [K]. Reference temperature T0 (absolute) of the lubricant properties."""
    refVis: float
    """Record 10.4.1 [N.s/m^2]. Viscosity of the lubricant at the reference temperature and low pressure."""
    prVisCoeff: float
    """Record 10.4.1 [m^2/N]. Pressure-viscosity coefficient of the lubricant."""
    tempVisCoeff: float
    """Record 10.4.1 [K]. Temperature coefficient b of the viscosity, in the law exp(b (1/T - 1/T0))."""
    lubTherCond: float
    """Record 10.4.1 [W/m/K]. Thermal conductivity of the lubricant (a real number, not an integer)."""
    lubDen: float
    """Record 10.4.1 [kg/m^3]. Density of the lubricant (a real number, not an integer)."""
    lubSpHeat: float
    """Record 10.4.1 [J/kg/K]. Specific heat of the lubricant (a real number, not an integer)."""
    refTracVis: float
    """Record 10.4.4 [N.s/m^2]. Reference viscosity of the lubricant for traction in the contact."""
    tracVisCoeff1: float
    """Record 10.4.4 [m^2/N]. Pressure coefficient a of the traction viscosity, in the law exp(a p + b (T0 - T))."""
    tracVisCoeff2: float
    """Record 10.4.4 [1/K]. Temperature coefficient b of the traction viscosity, in the law exp(a p + b (T0 - T))."""
    reCageTC1: float
    """Record 10.5.1A. Coefficient A of the traction coefficient (A + B u) exp(-C u) + D at slip speed u, element to
    cage."""
    reCageTC2: float
    """Record 10.5.1A [s/m]. Coefficient B of the traction coefficient (A + B u) exp(-C u) + D at slip speed u,
    element to cage."""
    reCageTC3: float
    """Record 10.5.1A [s/m]. Coefficient C of the traction coefficient (A + B u) exp(-C u) + D at slip speed u,
    element to cage."""
    reCageTC4: float
    """Record 10.5.1A. Coefficient D (value at large slip) of the traction coefficient (A + B u) exp(-C u) + D at
    slip speed u, element to cage."""
    cageRaceTC1: float
    """Record 10.5.2A. Coefficient A of the traction coefficient (A + B u) exp(-C u) + D at slip speed u, cage to
    race."""
    cageRaceTC2: float
    """Record 10.5.2A [s/m]. Coefficient B of the traction coefficient (A + B u) exp(-C u) + D at slip speed u, cage
    to race."""
    cageRaceTC3: float
    """Record 10.5.2A [s/m]. Coefficient C of the traction coefficient (A + B u) exp(-C u) + D at slip speed u, cage
    to race."""
    cageRaceTC4: float
    """Record 10.5.2A. Coefficient D (value at large slip) of the traction coefficient (A + B u) exp(-C u) + D at
    slip speed u, cage to race."""
    reReTC1: float
    """Record 10.5.3A. Coefficient A of the traction coefficient (A + B u) exp(-C u) + D at slip speed u, element to
    element."""
    reReTC2: float
    """Record 10.5.3A [s/m]. Coefficient B of the traction coefficient (A + B u) exp(-C u) + D at slip speed u,
    element to element."""
    reReTC3: float
    """Record 10.5.3A [s/m]. Coefficient C of the traction coefficient (A + B u) exp(-C u) + D at slip speed u,
    element to element."""
    reReTC4: float
    """Record 10.5.3A. Coefficient D (value at large slip) of the traction coefficient (A + B u) exp(-C u) + D at
    slip speed u, element to element."""
    pocVis: float
    """Record 10.6 [N.s/m^2]. Effective viscosity of the oil in the cage pockets."""
    gsVis: float
    """Record 10.6 [N.s/m^2]. Effective viscosity of the oil at the guide lands of the cage."""
    chnDen: float
    """Record 10.7A [kg/m^3]. Effective density of the oil-air mixture that causes churning drag."""
    chnVis: float
    """Record 10.7A [N.s/m^2]. Effective viscosity of the oil-air mixture that causes churning drag."""
    denRatio: float
    """Record 10.7B. Effective density of the churning medium divided by the built-in value. It is far below 1 for an
    oil mist."""
    visRatio: float
    """Record 10.7B. Effective viscosity of the churning medium divided by the built-in value."""
    gravityVecX: float
    """Record 11 [m/s^2]. Gravity acceleration along x."""
    gravityVecY: float
    """Record 11 [m/s^2]. Gravity acceleration along y."""
    gravityVecZ: float
    """Record 11 [m/s^2]. Gravity acceleration along z. With a negative value, gravity acts against the usual
    direction of the radial load."""
    ratingC: float
    """Record X1 [N]. Dynamic load rating C that the maker publishes. It replaces the ISO 281 estimate."""
    ratingC0: float
    """Record X1 [N]. Static load rating C0 that the maker publishes. It replaces the ISO 76 estimate."""
    ratingCu: float
    """Record X1 [N]. Fatigue load limit Cu (Pu) that the maker publishes. It replaces the ISO 281 estimate."""
    ratingE: float
    """Record X1. Limit e of the ratio of axial to radial load. Above this ratio, the load factors X and Y apply."""
    ratingX: float
    """Record X1. Radial load factor X for axial loads above e times the radial load."""
    ratingY: float
    """Record X1. Axial load factor Y for axial loads above e times the radial load."""
    ratingVM: float
    """Record X1 [N/m^2]. Von Mises fatigue limit stress of both races. It replaces the limit of the material in the
    stress-life models."""
    oilName: str
    """Record X2. Name of the oil; for documentation only."""
    kOilBase: int
    """Record X2. Base oil. It is used to estimate the oil properties that are not given. If not given: mineral oil."""
    kGrease: int
    """Record X2. Oil or grease."""
    oilGrade: int
    """Record X2. ISO viscosity grade: the viscosity at 40 °C in mm^2/s."""
    oilVisc1: float
    """Record X2 [mm^2/s]. Kinematic viscosity at oilTemp1. Give either this value or oilGrade."""
    oilTemp1: float
    """Record X2 [K]. Temperature of oilVisc1. If not given: 40 °C."""
    oilVisc2: float
    """Record X2 [mm^2/s]. Kinematic viscosity at oilTemp2."""
    oilTemp2: float
    """Record X2 [K]. Temperature of oilVisc2. If not given: 100 °C."""
    oilIndex: float
    """Record X2. Viscosity index. It is used with oilGrade, or with oilVisc1 at 40 °C. Estimates if not given: 95
    for mineral oil, 140 for polyalphaolefin and ester, 200 for polyglycol."""
    oilDen: float
    """Record X2 [kg/m^3]. Density of the oil at 15 °C. If not given: estimated from the base oil."""
    oilPrCoeff: float
    """Record X2 [m^2/N]. Pressure-viscosity coefficient of the oil at 40 °C. If not given: estimated from viscosity
    and base oil."""
    oilTemp: float
    """Record X2 [K]. Bearing temperature for the viscosity ratio of ISO 281. If not given: mean of the race
    temperatures."""
    matEM: np.ndarray
    """Record X3 [N/m^2]. Elastic modulus of outer race, inner race and rolling elements. A single value applies to
    all three. A given value replaces the elastic modulus of the material."""
    matPR: np.ndarray
    """Record X3. Poisson ratio of outer race, inner race and rolling elements."""
    matDen: np.ndarray
    """Record X3 [kg/m^3]. Density of outer race, inner race and rolling elements."""
    matCTE: np.ndarray
    """Record X3 [1/K]. Thermal expansion coefficient of outer race, inner race and rolling elements."""
    startAngle: float
    """Record X4 [deg]. Azimuth of rolling element 1 at the start and in the quasi-static solution. It is measured
    from the radial direction z and is positive about the bearing axis x. If not given: 0."""
