! ADRXN for Adore: normal force between THE_BODIES. This example adds damping during approach to the built-in law.
! Record 12.1 contains the damping time [s].
module force_law
  use adore_user
  implicit none
  real(c_double), save :: damping(1)
contains
  integer(c_int32_t) function adrxN(a) bind(c)
    type(adore_force), intent(inout) :: a
    real(c_double), pointer :: gap(:), rate(:), built_in(:), force(:)
    adrxN = 0
    if (a%call%mode == ADORE_READ) then
      a%call%active = 1
      if (adore_numbers(a%call, damping) /= 1) then
        call adore_fail(a%call, 'record 12 must contain the damping time')
        adrxN = 2
      end if
    end if
    if (a%call%mode /= ADORE_COMPUTE) return
    call c_f_pointer(a%gap, gap, [a%n])
    call c_f_pointer(a%gap_rate, rate, [a%n])
    call c_f_pointer(a%built_in, built_in, [a%n])
    call c_f_pointer(a%force, force, [a%n])
    force = max(0d0, built_in*(1 + damping(1)*rate/gap))
  end function
end module
