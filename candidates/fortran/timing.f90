!> The march of a single fibre, timed: `fibres --time` and the arguments of `../c/march`.
module timing
   use, intrinsic :: iso_fortran_env, only: error_unit, int64
   use equations, only: wp
   use fibres
   implicit none
   private
   public :: time_march

   integer(int64), parameter :: low_half = int(z'ffffffff', int64)

contains

   subroutine time_march()
      type(system_t) :: s
      real(wp) :: length, elements, density, area, modulus, courant, steps, repeat, best
      integer :: k, outcome
      integer(int64) :: start, now, rate

      length = argument('--length')
      elements = argument('--elements')
      density = argument('--density')
      area = argument('--area')
      modulus = argument('--modulus')
      courant = argument('--courant')
      steps = argument('--steps')
      repeat = argument('--repeat', 1.0_wp)
      s%impact_velocity = argument('--velocity')
      if (.not. (min(length, density, area, modulus, courant, steps, repeat) > 0 .and. elements >= 2)) &
         call refuse('a number must be positive, and the elements two or more')
      s%primary = fibre(length, int(elements), density, area, modulus)
      s%dt = courant*s%primary%crossing_time
      s%steps = nint(steps, int64)
      call with_time_step(s%primary, s%dt)

      best = huge(best)
      outcome = completed
      call system_clock(count_rate=rate)
      do k = 1, nint(repeat)
         call at_impact(s)
         call system_clock(start)
         outcome = completed
         do while (outcome == completed .and. s%step < s%steps)
            outcome = step(s)
         end do
         call system_clock(now)
         best = min(best, real(now - start, wp)/rate)
      end do
      if (outcome /= completed) call refuse('the run does not complete')
      write (*, '(a, i0, a, i0, a, es16.9, a, z16.16, a)') '{"steps":', s%steps, ',"element_steps":', &
         s%steps*s%primary%n, ',"seconds":', best, ',"checksum":"', checksum(s%primary), '"}'
   end subroutine time_march

   !> The number after a name on the command line.
   real(wp) function argument(name, otherwise) result(x)
      character(*), intent(in) :: name
      real(wp), intent(in), optional :: otherwise
      character(64) :: text
      integer :: i, status
      do i = 1, command_argument_count() - 1
         call get_command_argument(i, text)
         if (text /= name) cycle
         call get_command_argument(i + 1, text)
         read (text, *, iostat=status) x
         if (status /= 0) call refuse(name//' lacks a number')
         return
      end do
      if (.not. present(otherwise)) call refuse(name//' is missing')
      x = otherwise
   end function argument

   subroutine refuse(reason)
      character(*), intent(in) :: reason
      write (error_unit, '(a)') 'fibres --time: '//reason
      stop 1
   end subroutine refuse

   !> FNV-1a, 64 bits, over the bytes of positions, velocities and strains.
   pure integer(int64) function checksum(f) result(hash)
      type(fibre_t), intent(in) :: f
      integer :: i
      hash = ior(ishft(int(z'cbf29ce4', int64), 32), int(z'84222325', int64))
      do i = 0, f%n
         hash = fnv(fnv(hash, f%x(1, i)), f%x(2, i))
      end do
      do i = 0, f%n
         hash = fnv(fnv(hash, f%v(1, i)), f%v(2, i))
      end do
      do i = 1, f%n
         hash = fnv(hash, f%strain(i))
      end do
   end function checksum

   !> The product with the prime 2^40 + 435 modulo 2^64, in halves: no integer overflows.
   pure integer(int64) function fnv(before, value) result(hash)
      integer(int64), intent(in) :: before
      real(wp), intent(in) :: value
      integer(int64) :: bits, low, high
      integer :: byte
      hash = before
      bits = transfer(value, bits)
      do byte = 0, 7
         hash = ieor(hash, ibits(bits, 8*byte, 8))
         low = iand(hash, low_half)
         high = 435*ishft(hash, -32) + ishft(435*low, -32) + ishft(low, 8)
         hash = ior(ishft(high, 32), iand(435*low, low_half))
      end do
   end function fnv

end module timing
