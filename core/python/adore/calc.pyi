"""Written by write_stubs.py from the schema of the calculators; do not edit."""

from typing import Any, Dict, List, Literal, Mapping, Optional, Sequence, Union

class Result(Dict[str, Any]):
    units: Dict[str, str]
    def __getattr__(self, name: str) -> Any: ...

class Calculator:
    name: str
    purpose: str
    def describe(self) -> str: ...
    def calculations(self) -> List[Dict[str, Any]]: ...
    def example(self, kind: Optional[str] = ...) -> Dict[str, Any]: ...
    def __call__(self, inputs: Optional[Mapping[str, Any]] = ..., **more: Any) -> Result: ...

def calculators() -> Dict[str, Calculator]: ...
def calculate(name: str, inputs: Optional[Mapping[str, Any]] = ..., **more: Any) -> Result: ...

class _BallPocket(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        shape: Literal['cylindrical', 'spherical', 'elongated', 'rectangular', 'conical'] = ...,
        ball_diameter: float = ...,
        bPocCls1: float = ...,
        bPocCls2: float = ...,
        wall_z_low: float = ...,
        wall_z_high: float = ...,
        rotation_sign: int = ...,
        element_centre_pocket: Sequence[float] = ...,
        bPocClsVar1: float = ...,
        bPocClsVar2: float = ...,
    ) -> Result:
        """gap, contact point and contact angles of a ball in its pocket"""

class _BallStatics(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        geometry: Mapping[str, Any] = ...,
        material: Mapping[str, Any] = ...,
        speed_rpm: float = ...,
        ball_mass: float = ...,
        options: Mapping[str, Any] = ...,
        applied_load: Mapping[str, Any] = ...,
        prescribed_displacement: Mapping[str, Any] = ...,
    ) -> Result:
        """ball loads, contact angles and stiffness of a ball bearing under load and speed"""

class _BearingFit(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # interference, mounted_clearance
        bore: float = ...,
        od: float = ...,
        shaft: Any = ...,
        housing: Any = ...,
        ring_class: Any = ...,
        smoothing_shaft: float = ...,
        smoothing_housing: float = ...,
        clearance_least: float = ...,
        clearance_most: float = ...,
        type: Literal['ball', 'cylindrical_roller', 'spherical_roller'] = ...,
        re_dia: float = ...,
        pitch: float = ...,
        f1: float = ...,
        f2: float = ...,
        free_contact_angle: float = ...,
        shaft_id: float = ...,
        housing_od: float = ...,
        room_temp: float = ...,
        rpm1: float = ...,
        rpm2: float = ...,
        temps: Mapping[str, Any] = ...,
        materials: Mapping[str, Any] = ...,
    ) -> Result:
        """interference from tolerance classes; clearance after mounting and in operation"""

class _CageInertia(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        nRe: int = ...,
        element_diameter: float = ...,
        pitch_diameter: float = ...,
        cageDia1: float = ...,
        cageDia2: float = ...,
        cageWidth: float = ...,
        density: float = ...,
        bPocCls1: float = ...,
        bPocCls2: float = ...,
        shape: Literal['cylindrical', 'spherical', 'elongated', 'rectangular', 'conical'] = ...,
        roller_length: float = ...,
        cageConeAng_deg: float = ...,
    ) -> Result:
        """mass and moments of inertia of a cage with pockets"""

class _Churning(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # ball_drag, roller_drag, annulus_torque, disc_torque, spin_torque
        rho: float = ...,
        mu: float = ...,
        V: float = ...,
        D: float = ...,
        area: float = ...,
        length: float = ...,
        r: float = ...,
        c: float = ...,
        omega: float = ...,
    ) -> Result:
        """churning drag and torque of rolling elements, rings and discs in a fluid"""

class _Clearance(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # mounted_bearing, split_race
        type: Literal['ball', 'cylindrical_roller', 'spherical_roller'] = ...,
        bore: float = ...,
        od: float = ...,
        shaft_id: float = ...,
        housing_od: float = ...,
        re_dia: float = ...,
        pitch: float = ...,
        f1: float = ...,
        f2: float = ...,
        free_contact_angle: float = ...,
        fit1: float = ...,
        fit2: float = ...,
        room_temp: float = ...,
        rpm1: float = ...,
        rpm2: float = ...,
        rpm_cage: float = ...,
        temps: Mapping[str, Any] = ...,
        cage_id: float = ...,
        cage_od: float = ...,
        lands: Sequence[Any] = ...,
        materials: Mapping[str, Any] = ...,
        material_codes: Mapping[str, Any] = ...,
        free_clearance: float = ...,
        curvature_radius: float = ...,
        ball_dia: float = ...,
        shim: float = ...,
        measured_clearance: float = ...,
        center_distance_A: float = ...,
    ) -> Result:
        """operating fits, clearance and contact angle of a mounted bearing, also with a split race"""

class _EllipseTraction(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # ellipse_traction, ellipse_traction_exponential
        Q: float = ...,
        a: float = ...,
        b: float = ...,
        h0: float = ...,
        rho: Union[None, float] = ...,
        u0_c: float = ...,
        u0_t: float = ...,
        W: Sequence[float] = ...,
        law: Mapping[str, Any] = ...,
    ) -> Result:
        """traction, moment and heat of one contact ellipse"""

class _Film(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # point_film, elliptical_film, line_film
        formula: Literal['hamrockDowson', 'chittenden', 'line'] = ...,
        mu0: float = ...,
        alpha: float = ...,
        u: float = ...,
        Eprime: float = ...,
        Rx: float = ...,
        load: float = ...,
        k: float = ...,
        Re: float = ...,
        Rs: float = ...,
        R: float = ...,
        loadPerLength: float = ...,
    ) -> Result:
        """isothermal film thickness of point and line contacts"""

class _FilmHeating(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        L: float = ...,
        S: float = ...,
        pOverE: float = ...,
        floor: float = ...,
    ) -> Result:
        """reduction of the film thickness by shear heating in the inlet"""

class _FilmStarvation(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        m: float = ...,
        b: float = ...,
        R: float = ...,
        hFlooded: float = ...,
    ) -> Result:
        """reduction of the film thickness by starvation (oil meniscus near the contact)"""

class _Fits(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        inner_id: float = ...,
        interface_dia: float = ...,
        outer_od: float = ...,
        diametral_interference: float = ...,
        inner_part: Mapping[str, Any] = ...,
        outer_part: Mapping[str, Any] = ...,
    ) -> Result:
        """pressure, diameter changes and stresses of an interference fit"""

class _FlangeLoad(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        dia: float = ...,
        length: float = ...,
        half_angle: float = ...,
        end: int = ...,
        end_radius: float = ...,
        corner_radius: float = ...,
        pose: Mapping[str, Any] = ...,
        flange: Mapping[str, Any] = ...,
        material: Mapping[str, Any] = ...,
        race_speed: float = ...,
        roller_velocity: Sequence[float] = ...,
        roller_omega: Sequence[float] = ...,
        kappa: float = ...,
    ) -> Result:
        """load, slip, friction and heat of a roller end on a flange"""

class _FlangePlacing(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        dia: float = ...,
        length: float = ...,
        half_angle: float = ...,
        end_radius: Union[None, float] = ...,
        corner_radius: float = ...,
        side: Literal['outer', 'inner'] = ...,
        race_radius: float = ...,
        layback: Sequence[float] = ...,
        height: Sequence[float] = ...,
        play: float = ...,
        pose: Mapping[str, Any] = ...,
    ) -> Result:
        """flange root positions of a cylindrical race for a given total end play"""

class _FlashTemperature(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        b: float = ...,
        p0: float = ...,
        h: float = ...,
        ua: float = ...,
        ub: float = ...,
        Ta0: float = ...,
        Tb0: float = ...,
        muStar: float = ...,
        Tref: float = ...,
        alphaStar: float = ...,
        betaStar: float = ...,
        K: float = ...,
        kRhoCa: float = ...,
        kRhoCb: float = ...,
    ) -> Result:
        """surface temperatures of both bodies along one strip of a sheared film in the rolling direction"""

class _Fluid(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        code: int = ...,
        T: float = ...,
    ) -> Result:
        """properties of a coolant or churning medium at the temperature T [K]"""

class _GroovedTapered(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        dia: float = ...,
        crown_radius: float = ...,
        curvature_factor_outer: float = ...,
        curvature_factor_inner: float = ...,
        outer_half_angle: float = ...,
        inner_half_angle: float = ...,
    ) -> Result:
        """radius and center of the raceway profiles of a spherical tapered roller bearing"""

class _Growth(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # ring_thermal_growth, spin_growth
        inner_dia: float = ...,
        outer_dia: float = ...,
        cte: Union[Mapping[str, Any], float] = ...,
        temp_inner: float = ...,
        temp_outer: float = ...,
        room_temp: float = ...,
        material: Mapping[str, Any] = ...,
        rpm: float = ...,
    ) -> Result:
        """diameter changes of a ring by rotation or temperature"""

class _HeatedFilm(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # film_between_walls, reciprocal_film
        law: Literal['exponential', 'reciprocal'] = ...,
        U: float = ...,
        h: float = ...,
        mua: float = ...,
        mub: float = ...,
        beta: float = ...,
        K: float = ...,
        mu0: float = ...,
        alpha: float = ...,
        T0: float = ...,
        p: float = ...,
        T1: float = ...,
    ) -> Result:
        """shear stress and heat of a Newtonian film with shear heating"""

class _Hertz(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        body1: Mapping[str, Any] = ...,
        body2: Mapping[str, Any] = ...,
        load: float = ...,
        stress_poisson: float = ...,
        approach: float = ...,
        pressure: float = ...,
        half_axis: float = ...,
    ) -> Result:
        """elliptical Hertz contact: half axes, pressure, approach, subsurface stresses"""

class _HertzTraction(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        a: float = ...,
        b: float = ...,
        p0: float = ...,
        slip0: Sequence[float] = ...,
        spin: float = ...,
        law: Mapping[str, Any] = ...,
        slipPoly: Sequence[float] = ...,
        model: Literal['ellipse', 'strips'] = ...,
    ) -> Result:
        """traction force, moment and heat of a contact ellipse with slip and spin"""

class _Iso16281(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # roller_reference_life, half_loaded_ball_reference, ball_reference_life
        C: float = ...,
        Z: int = ...,
        alpha_deg: float = ...,
        gamma: float = ...,
        ns: int = ...,
        Q_roller: Sequence[float] = ...,
        lamina_weights: Sequence[float] = ...,
        lambda_nu: Any = ...,
        Cu: float = ...,
        eC: float = ...,
        kappa: float = ...,
        f_inner: float = ...,
        f_outer: float = ...,
        load_law: Any = ...,
        Fr: float = ...,
        Qi: Sequence[float] = ...,
        Qe: Sequence[float] = ...,
    ) -> Result:
        """ISO 16281 reference life from contact or lamina loads"""

class _Iso281(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # equivalent_load, ball_rating, thrust_ball_rating, roller_rating, thrust_roller_rating, deep_groove_equivalent_load, standard_factor, fatigue_load_limit, a_iso, contamination_factor, reference_viscosity, reliability_factor
        alpha_deg: float = ...,
        Fr: float = ...,
        Fa: float = ...,
        bearing: Union[Literal['radial_ball', 'angular_contact_ball', 'thrust_ball', 'radial_roller', 'thrust_roller'], Literal['radial_ball', 'angular_contact_ball'], Literal['radial_roller'], Literal['thrust_ball'], Literal['thrust_roller']] = ...,
        Dw: float = ...,
        Dpw: float = ...,
        Z: int = ...,
        i: int = ...,
        bm: float = ...,
        f_inner: float = ...,
        f_outer: float = ...,
        Dwe: float = ...,
        Lwe: float = ...,
        designation: Any = ...,
        P: float = ...,
        C0: float = ...,
        gamma: float = ...,
        table: Literal['f0', 'fc_radial_ball', 'fc_radial_roller', 'fc_thrust_ball_90'] = ...,
        sigma_Hu: float = ...,
        E: float = ...,
        nu: float = ...,
        kappa: float = ...,
        eC_Cu_over_P: float = ...,
        code: Literal['oil_online_13/10', 'oil_online_15/12', 'oil_online_17/14', 'oil_online_19/16', 'oil_offline_13/10', 'oil_offline_15/12', 'oil_offline_17/14', 'oil_offline_19/16', 'oil_offline_21/18', 'grease_high', 'grease_normal', 'grease_slight', 'grease_severe', 'grease_very_severe'] = ...,
        n_rpm: float = ...,
        S: float = ...,
    ) -> Result:
        """ISO 281 and ISO 76: load ratings, equivalent load, life factors a_1 and a_ISO, contamination factor, fatigue load limit C_u"""

class _JournalFilm(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        mu: float = ...,
        R: float = ...,
        L: float = ...,
        c: float = ...,
        eps: float = ...,
        omegaJournal: float = ...,
        omegaBearing: float = ...,
        attitudeRate: float = ...,
        epsRate: float = ...,
    ) -> Result:
        """force and torque of a cage on its guide land (short journal bearing)"""

class _Kinematics(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        Z: int = ...,
        D: float = ...,
        dm: float = ...,
        contact_angle_deg: float = ...,
        inner_speed_rpm: float = ...,
        outer_speed_rpm: float = ...,
    ) -> Result:
        """cage speed, ball speed and defect frequencies"""

class _LandGap(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        cageGsDia: float = ...,
        cageGsWidth: float = ...,
        cageGsPos: float = ...,
        cageGsCls: float = ...,
        iCageGuide: int = ...,
        slices: int = ...,
        cage_centre: Sequence[float] = ...,
        cage_angles_deg: Sequence[float] = ...,
        kCageGsImp: int = ...,
        cageGsRadVar: Sequence[float] = ...,
        kRaceGsImp: int = ...,
        raceGsRadVar: Sequence[float] = ...,
    ) -> Result:
        """gap of a guide land for a given cage position and orientation"""

class _LandLaw(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        cageGsWidth: float = ...,
        cageGsCls: float = ...,
        effective_modulus: float = ...,
        eccentricities: Sequence[float] = ...,
    ) -> Result:
        """load of a cage guide land for given eccentricities"""

class _Life(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # depth_integral_ratio, lundberg_palmgren_life, stress_life, hertz_contact, peak_stresses, axis_stresses
        p0: float = ...,
        b: Any = ...,
        limit_shear: float = ...,
        c: float = ...,
        h: float = ...,
        model: Literal['LP', 'LPU', 'GZ', 'IH'] = ...,
        geo: Mapping[str, Any] = ...,
        Qi: Sequence[float] = ...,
        Qo: Sequence[float] = ...,
        Estar: Any = ...,
        include_elements: bool = ...,
        inner_rotates: bool = ...,
        E_ball: float = ...,
        nu_ball: float = ...,
        limit: float = ...,
        user: Mapping[str, Any] = ...,
        Q: float = ...,
        race: Literal['inner', 'outer'] = ...,
        k: float = ...,
        nu: float = ...,
        z_over_b: float = ...,
    ) -> Result:
        """life of races, rolling elements and bearing from contact loads, with a selectable life model"""

class _LifeFactors(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # stle_factor, combined_factors, residual_stress_factor, film_factor, hardness_factor, filter_factor, tallian_factor
        material: Literal['AISI 52100', 'M-50', 'M-50 NiL', 'M-1', 'M-2', 'M-10', 'T-1', 'Halmo', 'M-42', 'WB-49', '440C', 'AISI 8620', 'AISI 9310', 'AISI 4320', 'CBS 600', 'CBS 1000M', 'Vasco X-2'] = ...,
        process: Literal['air', 'CVD', 'VAR', 'double VAR', 'VIM-VAR'] = ...,
        Rc: float = ...,
        lam: float = ...,
        lives: Mapping[str, Any] = ...,
        factors: Mapping[str, Any] = ...,
        e: float = ...,
        tau_max: float = ...,
        residual: float = ...,
        n: float = ...,
        filter: float = ...,
        facMat: float = ...,
        facProc: float = ...,
        facCont: float = ...,
        slope_rad: float = ...,
        aspTrac: float = ...,
    ) -> Result:
        """STLE and Tallian-type life factors"""

class _LifeStatistics(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # bearing_life, product_law, race_life, survival_factor
        Q: Sequence[float] = ...,
        Qc_inner: float = ...,
        Qc_outer: float = ...,
        inner_rotates: bool = ...,
        outer_rotates: bool = ...,
        e: float = ...,
        contact: Literal['point', 'line'] = ...,
        lives: Sequence[float] = ...,
        slopes: Sequence[float] = ...,
        S: float = ...,
        L_contacts: Sequence[Any] = ...,
        slope: float = ...,
    ) -> Result:
        """bearing life from the lives of its races (product of their survival probabilities); life at a given survival probability"""

class _LifeSum(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        dt_s: Sequence[float] = ...,
        n_rpm: Sequence[float] = ...,
        L_inner: Sequence[Any] = ...,
        L_outer: Sequence[Any] = ...,
        e: float = ...,
    ) -> Result:
        """Palmgren-Miner life of a load history"""

class _LineContact(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        load: float = ...,
        length: float = ...,
        body1: Mapping[str, Any] = ...,
        body2: Mapping[str, Any] = ...,
        stress_poisson: float = ...,
    ) -> Result:
        """line contact: half width, pressure, subsurface stresses, and approach from published formulas"""

class _LoadCapacity(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # ball_capacity, roller_capacity, point_constant_in_inches, line_constant_in_inches
        D: float = ...,
        f: float = ...,
        gamma: float = ...,
        Z: int = ...,
        alpha_deg: float = ...,
        lam: float = ...,
        dm: float = ...,
        fco: float = ...,
        l: float = ...,
        A: float = ...,
        B: float = ...,
    ) -> Result:
        """Lundberg-Palmgren load capacity of ball and roller races"""

class _Material(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        code: Any = ...,
        T: float = ...,
        part: Literal['rolling_element', 'outer_race', 'inner_race', 'housing', 'shaft', 'cage'] = ...,
    ) -> Result:
        """properties of a material with units and sources, at the temperature T [K] if T is given"""

class _MinimumLoad(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # share, radial_ball, cylindrical_roller, spherical_roller, thrust_ball, thrust_roller
        rule: Union[Literal['ball_share', 'roller_share'], Literal['cylindrical_roller'], Literal['deep_groove', 'self_aligning'], Literal['spherical_roller'], Literal['thrust_ball'], Literal['thrust_roller']] = ...,
        C: float = ...,
        F: float = ...,
        kr: float = ...,
        nu: float = ...,
        n: float = ...,
        d: float = ...,
        D: float = ...,
        n_ref: float = ...,
        C0: float = ...,
        A: float = ...,
    ) -> Result:
        """minimum load for rolling without sliding (formulas of a bearing manufacturer)"""

class _OscillatingLife(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # by_life, by_rating
        elements: Literal['ball', 'roller'] = ...,
        Z: int = ...,
        gamma: float = ...,
        swing_deg: float = ...,
        L10: float = ...,
        frequency: float = ...,
        C: float = ...,
        P: float = ...,
    ) -> Result:
        """life of an oscillating bearing and the critical angle of oscillation"""

class _PocketFilm(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        mu: float = ...,
        u: float = ...,
        Rx: float = ...,
        Ry: float = ...,
        h: float = ...,
        R: float = ...,
        hRate: float = ...,
    ) -> Result:
        """wedge film and squeeze film forces in a cage pocket"""

class _PocketFrame(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        nRe: int = ...,
        pocket: int = ...,
        azimuth_pocket_1_deg: float = ...,
        pitch_diameter: float = ...,
        cageDia1: float = ...,
        cageDia2: float = ...,
        element_centre_cage: Sequence[float] = ...,
        bPocCenVar1: float = ...,
        bPocCenVar2_deg: float = ...,
        bPocThknsVar: float = ...,
        bPocAngVar_deg: Sequence[float] = ...,
        cageConeAng_deg: float = ...,
    ) -> Result:
        """center and axes of a cage pocket"""

class _PocketLaw(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        ball_diameter: float = ...,
        E_element: float = ...,
        nu_element: float = ...,
        E_cage: float = ...,
        nu_cage: float = ...,
        cap_ratio: float = ...,
        gaps: Sequence[float] = ...,
        wall_curvatures: Sequence[float] = ...,
    ) -> Result:
        """contact load and stiffness of a ball in its pocket (Hertz law; linear at large penetrations)"""

class _RaceErrors(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # race_errors, race_errors_under_a_roller
        error: Mapping[str, Any] = ...,
        race_azimuth: Sequence[float] = ...,
        crown_radius: float = ...,
        side: Literal['outer', 'inner'] = ...,
        roller: Mapping[str, Any] = ...,
        r: float = ...,
        x: float = ...,
        n_slices: int = ...,
        land_width: float = ...,
    ) -> Result:
        """form errors of a race along the azimuth: radius, land offset, taper, curvature factor"""

class _ReferenceSpeed(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # by_series, by_factors
        type: Literal['radial', 'thrust_roller'] = ...,
        d: float = ...,
        D: float = ...,
        B: float = ...,
        C0: float = ...,
        series: Any = ...,
        f0r: float = ...,
        f1r: float = ...,
    ) -> Result:
        """ISO 15312: thermal reference speed from the balance of frictional heat and dissipated heat"""

class _RibLoads(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        dia: float = ...,
        outer_half_angle: float = ...,
        inner_half_angle: float = ...,
        length: float = ...,
        n_rollers: int = ...,
        thrust: float = ...,
        layback: float = ...,
        end_radius: float = ...,
        flange_height: float = ...,
        inner_speed: float = ...,
        density: float = ...,
        outer_speed: float = ...,
    ) -> Result:
        """race loads, rib load and rib contact of a tapered bearing under thrust"""

class _RigidBody(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        mass: float = ...,
        principal_moments: Sequence[float] = ...,
        frame_angles_deg: Sequence[float] = ...,
        mass_centre_to_geometric_centre: Sequence[float] = ...,
        quaternion_geometric_to_inertial: Sequence[float] = ...,
        omega_geometric: Sequence[float] = ...,
        mass_centre_velocity: Sequence[float] = ...,
        force_inertial: Sequence[float] = ...,
        force_point_geometric: Sequence[float] = ...,
        moment_inertial: Sequence[float] = ...,
    ) -> Result:
        """accelerations of a rigid body"""

class _RollerCorner(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        dia: float = ...,
        length: float = ...,
        half_angle: float = ...,
        end: int = ...,
        end_radius: Union[None, float] = ...,
        corner_radius: float = ...,
    ) -> Result:
        """torus geometry of the rounded corner between the side and the end of a roller"""

class _RollerFlange(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # sphere_end, flat_end
        dia: float = ...,
        length: float = ...,
        half_angle: float = ...,
        end: int = ...,
        end_radius: Any = ...,
        corner_radius: float = ...,
        pose: Mapping[str, Any] = ...,
        flange: Mapping[str, Any] = ...,
        material: Mapping[str, Any] = ...,
    ) -> Result:
        """gap, contact position, contact mode and load of a domed or flat roller end at a flange"""

class _RollerInertia(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        roller: Mapping[str, Any] = ...,
        density: float = ...,
        end_radius_1: Union[None, float] = ...,
        end_radius_2: Union[None, float] = ...,
        corners: bool = ...,
    ) -> Result:
        """mass, mass center and moments of inertia of a roller with crown, domed ends and corners"""

class _ShearThinningFilm(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        U: float = ...,
        h: float = ...,
        mu: float = ...,
        G: float = ...,
        n: float = ...,
        a: float = ...,
        beta: float = ...,
        K: float = ...,
    ) -> Result:
        """shear stress of a Carreau-Yasuda film, isothermal and with shear heating"""

class _SizeLimits(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # size, bearing_rings
        tolerance: Any = ...,
        nominal: float = ...,
        ring_class: Any = ...,
        bore: float = ...,
        od: float = ...,
    ) -> Result:
        """limits of size of shafts and bores (ISO 286) and of bearing rings (ISO 492)"""

class _SliceLoad(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        roller: Mapping[str, Any] = ...,
        n_slices: int = ...,
        delta0: float = ...,
        slope: float = ...,
        law: Mapping[str, Any] = ...,
        land: Mapping[str, Any] = ...,
    ) -> Result:
        """loads of roller slices within the raceway width, from a power law or an elastic half-space law"""

class _SlicePenetration(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        roller: Mapping[str, Any] = ...,
        n_slices: int = ...,
        pose: Mapping[str, Any] = ...,
        race: Mapping[str, Any] = ...,
    ) -> Result:
        """penetration of the slices of a roller into a race in three dimensions"""

class _SliceTraction(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        roller: Mapping[str, Any] = ...,
        n_slices: int = ...,
        K_line: float = ...,
        pose: Mapping[str, Any] = ...,
        race: Mapping[str, Any] = ...,
        kinematics: Mapping[str, Any] = ...,
        traction: Mapping[str, Any] = ...,
    ) -> Result:
        """slip, traction, force, moment and heat of a roller (divided into slices) on a race"""

class _SlicedLine(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        roller_length: float = ...,
        roller_diameter: float = ...,
        K_line: float = ...,
        n_slices: int = ...,
        profile: Literal['circular', 'logarithmic'] = ...,
        crown_radius: Union[Literal['inf'], None, float] = ...,
        tilt: float = ...,
        race_radius: float = ...,
        E: float = ...,
        nu: float = ...,
        approach_list: Sequence[float] = ...,
        load_list: Sequence[float] = ...,
    ) -> Result:
        """load and moment of a roller divided into slices, for a given approach and tilt"""

class _SphericalRow(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        dia: float = ...,
        crown_radius: float = ...,
        curvature_factor_outer: float = ...,
        curvature_factor_inner: float = ...,
        contact_angle: float = ...,
        pitch_diameter: float = ...,
        play: float = ...,
    ) -> Result:
        """radius and center of the raceway profiles for a row of spherical rollers"""

class _StaticSafety(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # static_safety, thrust_static_rating
        type: Literal['deep_groove', 'angular_contact', 'self_aligning', 'cylindrical_roller', 'tapered_roller', 'spherical_roller', 'thrust'] = ...,
        Fr: float = ...,
        Fa: float = ...,
        C0: float = ...,
        alpha_deg: float = ...,
        rows: int = ...,
        X0: float = ...,
        Y0: float = ...,
        Dw: float = ...,
        Lwe: float = ...,
        Dpw: float = ...,
        Z: int = ...,
        f: float = ...,
    ) -> Result:
        """ISO 76: equivalent static load P0, static safety factor s0, static load rating of thrust bearings"""

class _TaperedGeometry(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        dia: float = ...,
        outer_half_angle: float = ...,
        inner_half_angle: float = ...,
        length: float = ...,
        n_rollers: int = ...,
    ) -> Result:
        """geometry of a tapered bearing from the roller diameter and the two raceway angles"""

class _TaperedSpeeds(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        dia: float = ...,
        outer_half_angle: float = ...,
        inner_half_angle: float = ...,
        length: float = ...,
        inner_speed: float = ...,
        density: float = ...,
        outer_speed: float = ...,
    ) -> Result:
        """pure-rolling speeds and gyroscopic moment of a tapered roller"""

class _ThermalNetwork(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # ladder_network, nodal_network, convection
        rings: Mapping[str, Any] = ...,
        heat: Mapping[str, Any] = ...,
        split: Mapping[str, Any] = ...,
        kBaseTemp: int = ...,
        base_temp: float = ...,
        coolant: Mapping[str, Any] = ...,
        h_re: float = ...,
        h_cage: float = ...,
        area_re: float = ...,
        area_cage: float = ...,
        mdot_cp: float = ...,
        hA_re: float = ...,
        hA_cage: float = ...,
        G_re_outer: float = ...,
        G_re_inner: float = ...,
        hA_outer: float = ...,
        hA_inner: float = ...,
        fixed: Mapping[str, Any] = ...,
        shape: Literal['sphere', 'cylinder', 'rotating_ring'] = ...,
        diameter: float = ...,
        speed: float = ...,
        speed_unit: Any = ...,
        fluid: Mapping[str, Any] = ...,
    ) -> Result:
        """steady temperatures of shaft, races, elements, cage, housing, coolant; convection coefficients"""

class _ThermalSteps(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # thermal_steps, step_sequence
        end_times: Sequence[float] = ...,
        step_sizes: Sequence[float] = ...,
        heat: Sequence[float] = ...,
        aveTime: float = ...,
        skipTime: float = ...,
        kGeoMod: int = ...,
        temperatures: Sequence[Any] = ...,
        tol: float = ...,
        n_converged: int = ...,
        n_divergent: int = ...,
        limit: Union[None, float] = ...,
    ) -> Result:
        """mean heat of each thermal step; convergence of the temperatures from step to step"""

class _Traction(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kTrac: int = ...,
        T: float = ...,
        radius: float = ...,
        across: float = ...,
        Eprime: float = ...,
        pressure: float = ...,
        speed: float = ...,
        slip: Sequence[float] = ...,
        roughness: float = ...,
        criticalFilm: float = ...,
        meniscus: float = ...,
        metal: Sequence[float] = ...,
        stressLimit: bool = ...,
        recommended: bool = ...,
    ) -> Result:
        """traction, film thickness and lambda of a lubricant (code kTrac) in a point contact"""

class _TractionCurve(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        type: int = ...,
        tc: Sequence[float] = ...,
        slip: Sequence[float] = ...,
    ) -> Result:
        """traction coefficient versus slip, for four types of curve"""

class _Units(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # unit_constant, unit_conversion
        name: Literal['gc'] = ...,
        quantity: Literal['acceleration', 'area', 'density', 'energy', 'force', 'heat_flux', 'heat_transfer_coefficient', 'inertia', 'kinematic_viscosity', 'length', 'mass', 'mass_flow', 'moment', 'power', 'pressure', 'pressure_viscosity_coefficient', 'rotational_stiffness', 'specific_heat', 'stiffness', 'temperature', 'temperature_difference', 'temperature_viscosity_beta_T', 'temperature_viscosity_beta_per_T', 'thermal_conductivity', 'thermal_expansion', 'time', 'traction_slope', 'velocity', 'viscosity', 'volume', 'volume_flow', 'wear_rate'] = ...,
        direction: Literal['to_si', 'to_english'] = ...,
        values: Sequence[float] = ...,
    ) -> Result:
        """conversion of values between the SI and English systems"""

class _ViscoElasticFilm(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: Literal['sinh', 'atanh'] = ...,
        b: float = ...,
        p0: float = ...,
        h: float = ...,
        rollSpeed: float = ...,
        slip: Sequence[float] = ...,
        mu0: float = ...,
        alpha: float = ...,
        lnMuCap: float = ...,
        G0: float = ...,
        Gp: float = ...,
        tau0: float = ...,
        tau0p: float = ...,
    ) -> Result:
        """traction coefficient of a viscoelastic film along one strip of a contact in the rolling direction"""

class _Viscosity(Calculator):
    def __call__(  # type: ignore[override]
        self, inputs: Optional[Mapping[str, Any]] = ..., *,
        kind: str = ...,  # improved_yasutomi, vogel_scaling, hybrid, roelands, type_ii, type_i, lubricant
        law: Literal['lubricant', 'typeI', 'typeII', 'roelands', 'yasutomiImproved', 'hybrid', 'vogelScaling'] = ...,
        p: float = ...,
        T: float = ...,
        params: Mapping[str, Any] = ...,
        tait: Mapping[str, Any] = ...,
        muR: float = ...,
        TR: float = ...,
        Z: float = ...,
        S0: float = ...,
        mu0: float = ...,
        alpha: float = ...,
        beta: float = ...,
        T0: float = ...,
        kTrac: int = ...,
    ) -> Result:
        """viscosity at pressure and temperature, for a lubricant code or a viscosity law"""

ball_pocket: _BallPocket
ball_statics: _BallStatics
bearing_fit: _BearingFit
cage_inertia: _CageInertia
churning: _Churning
clearance: _Clearance
ellipse_traction: _EllipseTraction
film: _Film
film_heating: _FilmHeating
film_starvation: _FilmStarvation
fits: _Fits
flange_load: _FlangeLoad
flange_placing: _FlangePlacing
flash_temperature: _FlashTemperature
fluid: _Fluid
grooved_tapered: _GroovedTapered
growth: _Growth
heated_film: _HeatedFilm
hertz: _Hertz
hertz_traction: _HertzTraction
iso16281: _Iso16281
iso281: _Iso281
journal_film: _JournalFilm
kinematics: _Kinematics
land_gap: _LandGap
land_law: _LandLaw
life: _Life
life_factors: _LifeFactors
life_statistics: _LifeStatistics
life_sum: _LifeSum
line_contact: _LineContact
load_capacity: _LoadCapacity
material: _Material
minimum_load: _MinimumLoad
oscillating_life: _OscillatingLife
pocket_film: _PocketFilm
pocket_frame: _PocketFrame
pocket_law: _PocketLaw
race_errors: _RaceErrors
reference_speed: _ReferenceSpeed
rib_loads: _RibLoads
rigid_body: _RigidBody
roller_corner: _RollerCorner
roller_flange: _RollerFlange
roller_inertia: _RollerInertia
shear_thinning_film: _ShearThinningFilm
size_limits: _SizeLimits
slice_load: _SliceLoad
slice_penetration: _SlicePenetration
slice_traction: _SliceTraction
sliced_line: _SlicedLine
spherical_row: _SphericalRow
static_safety: _StaticSafety
tapered_geometry: _TaperedGeometry
tapered_speeds: _TaperedSpeeds
thermal_network: _ThermalNetwork
thermal_steps: _ThermalSteps
traction: _Traction
traction_curve: _TractionCurve
units: _Units
visco_elastic_film: _ViscoElasticFilm
viscosity: _Viscosity
