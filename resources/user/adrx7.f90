! ADRX7 for Adore: traction coefficient as a function of slip, kappa = (A + B u) exp(-C u) + D. Record 12.1 contains A to D.
module law
  use adore_user
  implicit none
  real(c_double), save :: c(4)
contains
  integer(c_int32_t) function adrx7(a) bind(c)
    type(adore_adrx7), intent(inout) :: a
    real(c_double), pointer :: u(:), kappa(:)
    character(160) :: text
    adrx7 = 0
    select case (a%call%mode)
    case (ADORE_READ)
      a%call%active = 1
      if (adore_numbers(a%call, c) /= 4) then
        call adore_fail(a%call, 'record 12 must contain A, B, C and D of the traction curve')
        adrx7 = 2
      end if
    case (ADORE_START)
      write (text, '(a, 4(1x, g0))') 'kappa = (A + B u) exp(-C u) + D, A to D:', c
      call adore_print_line(a%call, text)
      if (c(3) > 0 .and. c(1) + c(4) == 0) a%slip_scale = 1 / c(3)
      a%wants_points = 0
    case (ADORE_COMPUTE)
      call c_f_pointer(a%slip, u, [a%points*a%stride])
      call c_f_pointer(a%kappa, kappa, [a%points*a%stride])
      kappa = (c(1) + c(2)*u)*exp(-c(3)*u) + c(4)
    end select
  end function
end module
