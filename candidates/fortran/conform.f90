!> The conversation of docs/conformance.md: a question a line, an answer a line. With `--time`, a time.
program conform
   use, intrinsic :: ieee_arithmetic
   use, intrinsic :: iso_fortran_env, only: input_unit, output_unit, int64
   use equation_questions
   use equations, only: wp
   use fibres
   use json
   use timing, only: time_march
   implicit none

   character(*), parameter :: hello = '"format":"crossfibre-conformance/1","name":"Fortran 2008","number":"f64",' &
      //'"depths":["equation","step","run"],"laws":["linear"],"dimensions":[2,3],' &
      //'"strain":["incremental","engineering"],"corrections":["all"]'
   real(wp), parameter :: most_elements = 1e6_wp, most_steps = 1e9_wp

   !> Why there is no answer: a question that cannot be read, or one for another program.
   type :: trouble_t
      character(:), allocatable :: kind, text
   end type trouble_t

   type(json_t) :: question
   character(:), allocatable :: line
   character(6) :: asked
   logical :: ended

   call get_command_argument(1, asked)
   ended = asked == '--time'
   if (ended) call time_march()
   do while (.not. ended)
      call read_line(line, ended)
      if (ended) exit
      call answer(line)
      flush (output_unit)
   end do

contains

   ! ---- Questions in, answers out ----

   subroutine read_line(line, ended)
      character(:), allocatable, intent(out) :: line
      logical, intent(out) :: ended
      character(65536) :: chunk
      integer :: got, status
      line = ''
      do
         read (input_unit, '(a)', advance='no', size=got, iostat=status) chunk
         line = line//chunk(:got)
         if (status /= 0) exit
      end do
      ended = .not. is_iostat_eor(status) .and. len(line) == 0
   end subroutine read_line

   subroutine put(text)
      character(*), intent(in) :: text
      write (output_unit, '(a)', advance='no') text
   end subroutine put

   subroutine answer(line)
      character(*), intent(in) :: line
      type(trouble_t) :: trouble
      integer :: id
      if (question%read(line)) then
         id = question%member(1, 'id')
         call put('{"id":')
         if (id == none) call put('null')
         if (id /= none) call put(question%raw(id))
         call put(',')
         call answer_question(trouble)
      else
         call put('{"id":null,')
         trouble = trouble_t('error', 'not JSON')
      end if
      if (allocated(trouble%kind)) call put('"'//trouble%kind//'":"'//trouble%text//'"')
      write (output_unit, '(a)') '}'
   end subroutine answer

   !> Writes all of the answer but its `id`, and nothing where there is trouble.
   subroutine answer_question(trouble)
      type(trouble_t), intent(out) :: trouble
      type(system_t) :: s
      integer :: ask, outcome
      ask = question%member(1, 'ask')
      if (question%is(ask, 'hello')) then
         call put(hello)
      else if (question%is(ask, 'equation')) then
         call answer_equation(trouble)
      else if (question%is(ask, 'step') .or. question%is(ask, 'run')) then
         call read_scene(question%member(1, 'scene'), s, trouble)
         if (allocated(trouble%kind)) return
         if (question%is(ask, 'run')) then
            outcome = run(s)
            call put_result(s, outcome)
         else
            call read_state(question%member(1, 'state'), s, trouble)
            if (allocated(trouble%kind)) return
            outcome = step(s)
            call put_state(s)
         end if
      else
         trouble = trouble_t('skip', 'not a question that this program knows')
      end if
   end subroutine answer_question

   ! ---- Numbers out ----

   subroutine put_number(x)
      real(wp), intent(in) :: x
      character(24) :: text
      if (ieee_is_nan(x)) then
         call put('"NaN"')
      else if (.not. ieee_is_finite(x)) then
         call put(trim(merge('"inf" ', '"-inf"', x > 0)))
      else
         write (text, '(es24.16e3)') x ! 17 digits
         call put(trim(adjustl(text)))
      end if
   end subroutine put_number

   subroutine put_count(n)
      integer(int64), intent(in) :: n
      character(20) :: text
      write (text, '(i0)') n
      call put(trim(text))
   end subroutine put_count

   subroutine put_list(x)
      real(wp), intent(in) :: x(:)
      integer :: i
      call put('[')
      do i = 1, size(x)
         if (i > 1) call put(',')
         call put_number(x(i))
      end do
      call put(']')
   end subroutine put_list

   subroutine put_vectors(x)
      real(wp), intent(in) :: x(:, :)
      integer :: i
      call put('[')
      do i = 1, size(x, 2)
         if (i > 1) call put(',')
         call put_list(x(:, i))
      end do
      call put(']')
   end subroutine put_vectors

   subroutine put_fibre(f)
      type(fibre_t), intent(in) :: f
      call put('{"position":')
      call put_vectors(f%x)
      call put(',"velocity":')
      call put_vectors(f%v)
      call put(',"strain":')
      call put_list(f%strain)
      call put(',"tension":')
      call put_list(f%tension)
      call put('}')
   end subroutine put_fibre

   subroutine put_fibres(s)
      type(system_t), intent(in) :: s
      call put('"primary":')
      call put_fibre(s%primary)
      if (.not. s%crossed) return
      call put(',"secondary":')
      call put_fibre(s%secondary)
      call put(',"crossover":{"node":')
      call put_count(int(s%ix, int64))
      call put(',"moves":')
      call put_count(s%moves)
      call put('}')
   end subroutine put_fibres

   subroutine put_state(s)
      type(system_t), intent(in) :: s
      call put('"state":{"step":')
      call put_count(s%step)
      call put(',')
      call put_fibres(s)
      call put(',"projectile_velocity":')
      call put_number(s%v_p)
      call put('}')
   end subroutine put_state

   subroutine put_result(s, outcome)
      type(system_t), intent(in) :: s
      integer, intent(in) :: outcome
      character(14) :: kind
      select case (outcome)
      case (completed)
         kind = 'completed'
      case (diverged)
         kind = 'diverged'
      case (crossover_left)
         kind = 'crossover_left'
      end select
      call put('"result":{"format":"crossfibre-result/1","outcome":{"kind":"'//trim(kind)//'"},"time":')
      call put_number(s%step*s%dt)
      call put(',"steps":')
      call put_count(s%step)
      call put(',"time_step":')
      call put_number(s%dt)
      call put(',')
      call put_fibres(s)
      call put(',"projectile":{"velocity":')
      call put_number(s%v_p)
      call put(',"position":')
      call put_number(s%primary%x(2, 0))
      call put('}}')
   end subroutine put_result

   ! ---- A scene and a state in ----

   !> A number of an object that must be positive. Clears `good` where it is not.
   real(wp) function positive(object, name, good) result(x)
      integer, intent(in) :: object
      character(*), intent(in) :: name
      logical, intent(inout) :: good
      x = question%number(question%member(object, name), good)
      good = good .and. x > 0 .and. ieee_is_finite(x)
   end function positive

   subroutine read_fibre(made, f, trouble)
      integer, intent(in) :: made
      type(fibre_t), intent(out) :: f
      type(trouble_t), intent(inout) :: trouble
      real(wp) :: length, elements, density, area, modulus
      integer :: material
      logical :: good
      material = question%member(made, 'material')
      if (.not. question%is(question%member(material, 'law'), 'linear')) then
         trouble = trouble_t('skip', 'only the linear law')
      else if (question%values(material)%count /= 2) then
         trouble = trouble_t('skip', 'neither tension_only nor artificial_viscosity')
      end if
      if (allocated(trouble%kind)) return
      good = .true.
      length = positive(made, 'length', good)
      elements = positive(made, 'elements', good)
      density = positive(made, 'density', good)
      area = positive(made, 'area', good)
      modulus = positive(material, 'modulus', good)
      if (.not. good) then
         trouble = trouble_t('error', 'a fibre lacks a positive number')
      else if (elements < 2 .or. elements > most_elements) then
         trouble = trouble_t('error', 'too few or too many elements')
      else
         f = fibre(length, int(elements), density, area, modulus)
      end if
   end subroutine read_fibre

   subroutine read_scene(scene, s, trouble)
      integer, intent(in) :: scene
      type(system_t), intent(out) :: s
      type(trouble_t), intent(inout) :: trouble
      integer :: projectile, secondary, mass, text
      real(wp) :: courant, duration, steps
      logical :: good

      text = question%member(scene, 'corrections')
      if (text /= none .and. .not. question%is(text, 'all')) then
         trouble = trouble_t('skip', 'all corrections only')
         return
      end if
      s%engineering = question%is(question%member(scene, 'strain'), 'engineering')
      projectile = question%member(scene, 'projectile')
      secondary = question%member(scene, 'secondary')
      mass = question%member(projectile, 'mass')
      s%has_mass = mass /= none
      s%crossed = secondary /= none
      good = .true.
      s%impact_velocity = question%number(question%member(projectile, 'velocity'), good)
      if (s%has_mass) s%projectile_mass = question%number(mass, good)
      if (s%crossed) then
         s%at = question%number(question%member(secondary, 'at'), good)
         s%alpha_s = question%number(question%member(secondary, 'slide_factor'), good)
      end if
      courant = positive(scene, 'courant', good)
      duration = positive(scene, 'duration', good)
      call read_fibre(question%member(scene, 'primary'), s%primary, trouble)
      if (s%crossed .and. .not. allocated(trouble%kind)) call read_fibre(secondary, s%secondary, trouble)
      if (allocated(trouble%kind)) return
      s%dt = courant*s%primary%crossing_time
      if (s%crossed) s%dt = courant*min(s%primary%crossing_time, s%secondary%crossing_time)
      steps = duration/s%dt
      if (.not. (good .and. s%dt > 0 .and. steps <= most_steps)) then
         trouble = trouble_t('error', 'the scene lacks a number, or it has too many steps')
         return
      end if
      s%steps = nint(steps, int64)
      call with_time_step(s%primary, s%dt)
      if (s%crossed) call with_time_step(s%secondary, s%dt)
      call at_impact(s)
      if (s%ix >= s%primary%n) trouble = trouble_t('error', 'the crossover is at the clamp')
   end subroutine read_scene

   subroutine read_vectors(list, x, good)
      integer, intent(in) :: list
      real(wp), intent(inout) :: x(:, :)
      logical, intent(inout) :: good
      integer :: at, i
      at = question%items(list, size(x, 2))
      good = good .and. at /= none
      if (at == none) return
      do i = 1, size(x, 2)
         x(:, i) = question%all_numbers(at, size(x, 1), good)
         at = question%values(at)%next
      end do
   end subroutine read_vectors

   subroutine read_fibre_state(object, f, good)
      integer, intent(in) :: object
      type(fibre_t), intent(inout) :: f
      logical, intent(inout) :: good
      call read_vectors(question%member(object, 'position'), f%x, good)
      call read_vectors(question%member(object, 'velocity'), f%v, good)
      f%strain = question%all_numbers(question%member(object, 'strain'), f%n, good)
      f%tension = question%all_numbers(question%member(object, 'tension'), f%n, good)
   end subroutine read_fibre_state

   integer(int64) function read_count(value, most, good) result(n)
      integer, intent(in) :: value
      real(wp), intent(in) :: most
      logical, intent(inout) :: good
      real(wp) :: x
      n = 0
      x = question%number(value, good)
      good = good .and. x >= 0 .and. x <= most
      if (good) n = int(x, int64)
   end function read_count

   subroutine read_state(state, s, trouble)
      integer, intent(in) :: state
      type(system_t), intent(inout) :: s
      type(trouble_t), intent(inout) :: trouble
      integer :: crossover
      logical :: good
      good = .true.
      s%step = read_count(question%member(state, 'step'), most_steps, good)
      s%v_p = question%number(question%member(state, 'projectile_velocity'), good)
      call read_fibre_state(question%member(state, 'primary'), s%primary, good)
      if (s%crossed) then
         call read_fibre_state(question%member(state, 'secondary'), s%secondary, good)
         crossover = question%member(state, 'crossover')
         s%ix = int(read_count(question%member(crossover, 'node'), s%primary%n - 1.0_wp, good))
         s%moves = read_count(question%member(crossover, 'moves'), most_steps, good)
      end if
      if (.not. good) trouble = trouble_t('error', 'the state does not fit the scene')
   end subroutine read_state

   ! ---- An equation ----

   subroutine answer_equation(trouble)
      type(trouble_t), intent(inout) :: trouble
      integer :: edition, corrections
      logical :: engineering, good
      real(wp), allocatable :: out(:)
      edition = question%member(1, 'edition')
      corrections = question%member(edition, 'corrections')
      if (corrections /= none .and. .not. question%is(corrections, 'all')) then
         trouble = trouble_t('skip', 'all corrections only')
         return
      end if
      engineering = question%is(question%member(edition, 'strain'), 'engineering')
      good = .true.
      call evaluate(question, question%member(1, 'eq'), question%member(1, 'in'), engineering, out, good)
      if (size(out) == 0) then
         trouble = trouble_t('skip', 'not an equation of the page')
      else if (.not. good) then
         trouble = trouble_t('error', 'an input of the equation is missing')
      else
         call put('"out":')
         if (size(out) == 1) call put_number(out(1))
         if (size(out) > 1) call put_list(out)
      end if
   end subroutine answer_equation

end program conform
