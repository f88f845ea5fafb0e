! ADRX1 for Adore: the two examples of the manual (see adrx1.c). Record 12.1 contains t1, t2, rpm1, rpm2 of the inner race,
! record 12.2 amplitude [m] and frequency [Hz] of the housing along z.
module motion
  use adore_user
  implicit none
  real(c_double), parameter :: pi = 3.14159265358979323846d0
  real(c_double), save :: race(4), shake(2), w, spin_up
contains
  integer(c_int32_t) function adrx1(a) bind(c)
    type(adore_adrx1), intent(inout) :: a
    character(160) :: text
    adrx1 = 0
    select case (a%call%mode)
    case (ADORE_READ)
      a%call%active = 1
      if (adore_numbers(a%call, race) /= 4) then
        call adore_fail(a%call, 'record 12.1 must contain t1, t2, rpm1 and rpm2')
        adrx1 = 2
      end if
      if (adore_numbers(a%call, shake) /= 2) then
        call adore_fail(a%call, 'record 12.2 must contain the amplitude and frequency of the housing')
        adrx1 = 2
      end if
    case (ADORE_START)
      w = 2*pi*shake(2)
      spin_up = 0
      if (race(2) > race(1)) spin_up = (race(4) - race(3))*pi/30/(race(2) - race(1))
      if (spin_up /= 0) then
        a%drives(2) = 1
        a%kinks(1:2) = race(1:2)
        a%kink_count = 2
        write (text, '(a, 4(1x, g0))') 'inner race: t1, t2, rpm1, rpm2', race
        call adore_print_line(a%call, text)
      end if
      if (shake(1) /= 0) then
        a%drives(1) = 1
        a%start_velocity(3, 1) = shake(1)*w
        a%longest_step = 0.05d0/shake(2)
        write (text, '(a, 2(1x, g0))') 'housing along z: amplitude, frequency', shake
        call adore_print_line(a%call, text)
      end if
    case (ADORE_COMPUTE)
      if (a%call%time >= race(1) .and. a%call%time < race(2)) a%angular_acceleration(1, 2) = spin_up
      a%acceleration(3, 1) = -shake(1)*w*w*sin(w*a%call%time)
    end select
  end function
end module
