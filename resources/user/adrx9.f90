! ADRX9 for Adore: the third example of the manual, all local heat sources with position and size in SOL9 (see adrx9.c).
module heat_map
  use adore_user
  implicit none
contains
  integer(c_int32_t) function adrx9(a) bind(c)
    type(adore_adrx9), intent(inout) :: a
    integer(c_int32_t), pointer :: kind(:), element(:), race(:)
    real(c_double), pointer :: heat(:), place(:, :), size_of(:, :)
    character(200) :: line
    integer(c_int64_t) :: i
    adrx9 = 0
    if (a%call%mode == ADORE_READ) a%call%active = 1
    if (a%call%mode == ADORE_START) call adore_write_line(a%call, '#       time kind element race          x' // &
      '          y          z          a          b         heat')
    if (a%call%mode /= ADORE_STEP) return
    call c_f_pointer(a%source_kind, kind, [a%sources])
    call c_f_pointer(a%source_element, element, [a%sources])
    call c_f_pointer(a%source_race, race, [a%sources])
    call c_f_pointer(a%source_heat, heat, [a%sources])
    call c_f_pointer(a%source_place, place, [3_c_int64_t, a%sources])
    call c_f_pointer(a%source_size, size_of, [2_c_int64_t, a%sources])
    do i = 1, a%sources
      write (line, '(es12.6e2, 1x, i4, 1x, i7, 1x, i4, 5(1x, es10.3e2), 1x, es12.5e2)') a%call%time, kind(i), &
        element(i) + 1, race(i) + 1, place(:, i), size_of(:, i), heat(i)
      call adore_write_line(a%call, trim(line))
    end do
  end function
end module
