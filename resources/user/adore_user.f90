! Interface of the user routines of Adore for Fortran: the structures of adore_user.h and the services.
module adore_user
  use, intrinsic :: iso_c_binding
  implicit none
  integer(c_int32_t), parameter :: ADORE_USER_ABI = 1
  integer(c_int32_t), parameter :: ADORE_READ = -1, ADORE_START = 0, ADORE_COMPUTE = 1, ADORE_PRINT = 2, ADORE_STEP = 3
  integer(c_int32_t), parameter :: ADORE_ELEMENT_RACE = 0, ADORE_ELEMENT_CAGE = 1, ADORE_CAGE_RACE = 2
  integer(c_int32_t), parameter :: ADORE_ROLLER_FLANGE = 3, ADORE_ELEMENT_ELEMENT = 4

  type, bind(c) :: adore_services
    type(c_funptr) :: read_numbers, read_line, print, write, fail
  end type
  type, bind(c) :: adore_call
    integer(c_int32_t) :: abi, size, hook, mode, active, unused
    integer(c_int64_t) :: step
    real(c_double) :: time
    type(c_ptr) :: user, host, services, bearing
  end type
  type, bind(c) :: adore_bearing
    integer(c_int32_t) :: elements, rollers
    real(c_double) :: element_diameter, pitch_diameter, element_mass, race_speed(2), time_scale
  end type
  type, bind(c) :: adore_adrx0
    type(adore_call) :: call
    integer(c_int32_t) :: part, unused
    real(c_double) :: density, elastic_modulus, poisson_ratio, thermal_expansion, conductivity, specific_heat
    real(c_double) :: elastic_strain_limit, hardness, wear_coefficient, fatigue_limit_stress
  end type
  type, bind(c) :: adore_adrx1
    type(adore_call) :: call
    integer(c_int32_t) :: drives(2), moves_frame, suppress_element_axial, suppress_element_tilt, suppress_element_all
    integer(c_int32_t) :: suppress_cage_axial, suppress_cage_tilt
    real(c_double) :: start_velocity(3, 2), start_spin(2), longest_step, kinks(8)
    integer(c_int32_t) :: kink_count, unused
    real(c_double) :: position(3, 2), velocity(3, 2), omega(3, 2), angle(2)
    real(c_double) :: force(3, 2), moment(3, 2), acceleration(3, 2), angular_acceleration(3, 2), frame_acceleration(3)
    real(c_double) :: frame_omega(3), frame_angular_acceleration(3)
  end type
  type, bind(c) :: adore_force
    type(adore_call) :: call
    integer(c_int64_t) :: n
    type(c_ptr) :: element, surface, gap, gap_rate, built_in, force
  end type
  type, bind(c) :: adore_surface
    type(adore_call) :: call
    integer(c_int32_t) :: race, element
    integer(c_int64_t) :: n
    type(c_ptr) :: axial, azimuth, radius, curvature_factor
  end type
  type, bind(c) :: adore_adrx7
    type(adore_call) :: call
    integer(c_int32_t) :: kind, race
    real(c_double) :: slip_scale
    integer(c_int32_t) :: wants_points, unused
    integer(c_int64_t) :: n, points, stride
    type(c_ptr) :: slip, pressure, load, peak_pressure, half_major, half_minor, entrainment, curvature, middle_slip, kappa
  end type
  type, bind(c) :: adore_adrx8
    type(adore_call) :: call
    integer(c_int32_t) :: elements_wanted, pockets_wanted, inertia_wanted, unused
    integer(c_int64_t) :: n
    type(c_ptr) :: diameter, crown_radius, length, central_length, land_offset, pocket_clearance1, pocket_clearance2
    type(c_ptr) :: pocket_thickness, pocket_axial, pocket_angular, pocket_tilt
    real(c_double) :: mass, moments(3), geometric_centre(3), frame(3)
  end type
  type, bind(c) :: adore_adrx9
    type(adore_call) :: call
    real(c_double) :: step_size, total_heat
    integer(c_int64_t) :: n
    type(c_ptr) :: x, r, theta, load, contact_angle
    integer(c_int64_t) :: sources
    type(c_ptr) :: source_kind, source_element, source_race, source_heat, source_place, source_size, source_name
    integer(c_int32_t) :: wants_channels, unused
    integer(c_int64_t) :: channels
    type(c_ptr) :: channel_name, channel_size, channel_first
    integer(c_int64_t) :: channel_values
    type(c_ptr) :: channel_value
  end type

  abstract interface
    integer(c_int32_t) function numbers_service(host, values, count) bind(c)
      import
      type(c_ptr), value :: host
      real(c_double) :: values(*)
      integer(c_int32_t), value :: count
    end function
    subroutine text_service(host, text) bind(c)
      import
      type(c_ptr), value :: host
      character(kind=c_char) :: text(*)
    end subroutine
  end interface

contains

  integer(c_int32_t) function adore_user_abi_version() bind(c, name="adore_user_abi")
    adore_user_abi_version = ADORE_USER_ABI
  end function

  ! Reads the next numbers of records 12.x; returns the number of values read.
  integer function adore_numbers(call, values)
    type(adore_call), intent(in) :: call
    real(c_double), intent(out) :: values(:)
    type(adore_services), pointer :: s
    procedure(numbers_service), pointer :: service
    call c_f_pointer(call%services, s)
    call c_f_procpointer(s%read_numbers, service)
    adore_numbers = service(call%host, values, int(size(values), c_int32_t))
  end function

  subroutine say(which, call, text)
    type(c_funptr), intent(in) :: which
    type(adore_call), intent(in) :: call
    character(*), intent(in) :: text
    character(kind=c_char) :: with_end(len(text) + 1)
    procedure(text_service), pointer :: service
    integer :: i
    do i = 1, len(text)
      with_end(i) = text(i:i)
    end do
    with_end(len(text) + 1) = c_null_char
    call c_f_procpointer(which, service)
    call service(call%host, with_end)
  end subroutine

  subroutine adore_print_line(call, text) ! to PRINT.txt
    type(adore_call), intent(in) :: call
    character(*), intent(in) :: text
    type(adore_services), pointer :: s
    call c_f_pointer(call%services, s)
    call say(s%print, call, trim(text))
  end subroutine

  subroutine adore_write_line(call, text) ! to SOL9
    type(adore_call), intent(in) :: call
    character(*), intent(in) :: text
    type(adore_services), pointer :: s
    call c_f_pointer(call%services, s)
    call say(s%write, call, text // achar(10))
  end subroutine

  subroutine adore_fail(call, text) ! reason of a return value other than 0
    type(adore_call), intent(in) :: call
    character(*), intent(in) :: text
    type(adore_services), pointer :: s
    call c_f_pointer(call%services, s)
    call say(s%fail, call, trim(text))
  end subroutine
end module
