!> A small reader of JSON: one text becomes one flat list of values.
!>
!> A value stands before all that it holds; an object holds its keys and their values in turn. Strings are
!> places in the text, with their escapes as they came. Nesting deeper than `most_depth` is refused.
module json
   use, intrinsic :: ieee_arithmetic
   use, intrinsic :: iso_fortran_env, only: wp => real64
   implicit none
   private
   public :: json_t, none
   public :: is_array, is_number, is_object, is_string, is_word

   integer, parameter :: none = 0 !< no such value; every function takes it for one
   integer, parameter :: is_word = 0, is_number = 1, is_string = 2, is_array = 3, is_object = 4
   integer, parameter :: most_depth = 64

   type :: value_t
      integer :: kind = is_word
      integer :: first = 0, last = 0 !< where it is in the text, with its quotes and brackets
      integer :: count = 0           !< of an array: values; of an object: keys
      integer :: next = 0            !< index of the value behind it and all that it holds
      real(wp) :: number = 0
   end type value_t

   type :: json_t
      character(:), allocatable :: text
      type(value_t), allocatable :: values(:) !< the first is the whole
      integer :: used = 0
   contains
      procedure :: read => read_text
      procedure :: member, items, is, number, all_numbers, raw
   end type json_t

   !> How far a text has been read.
   type :: reader_t
      integer :: at = 1
      logical :: good = .true.
   end type reader_t

contains

   !> Whether the text is JSON.
   logical function read_text(this, text)
      class(json_t), intent(inout) :: this
      character(*), intent(in) :: text
      type(reader_t) :: reader
      this%text = text
      if (.not. allocated(this%values)) allocate (this%values(256))
      this%used = 0
      call read_value(this, reader, 0)
      read_text = reader%good .and. reader%at == len(text) + 1
   end function read_text

   !> The character here; NUL behind the end.
   pure character function here(this, reader)
      type(json_t), intent(in) :: this
      type(reader_t), intent(in) :: reader
      here = achar(0)
      if (reader%at <= len(this%text)) here = this%text(reader%at:reader%at)
   end function here

   !> Goes over a character if it is this one.
   logical function took(this, reader, c)
      type(json_t), intent(in) :: this
      type(reader_t), intent(inout) :: reader
      character, intent(in) :: c
      took = here(this, reader) == c
      if (took) reader%at = reader%at + 1
   end function took

   subroutine skip_space(this, reader)
      type(json_t), intent(in) :: this
      type(reader_t), intent(inout) :: reader
      do while (scan(here(this, reader), ' '//achar(9)//achar(10)//achar(13)) == 1)
         reader%at = reader%at + 1
      end do
   end subroutine skip_space

   !> A new value that begins here; its index.
   integer function begin(this, reader, kind)
      type(json_t), intent(inout) :: this
      type(reader_t), intent(in) :: reader
      integer, intent(in) :: kind
      type(value_t), allocatable :: more(:)
      if (this%used == size(this%values)) then
         allocate (more(2*this%used))
         more(:this%used) = this%values
         call move_alloc(more, this%values)
      end if
      this%used = this%used + 1
      begin = this%used
      this%values(begin) = value_t(kind=kind, first=reader%at)
   end function begin

   subroutine finish(this, reader, index)
      type(json_t), intent(inout) :: this
      type(reader_t), intent(in) :: reader
      integer, intent(in) :: index
      this%values(index)%last = reader%at - 1
      this%values(index)%next = this%used + 1
   end subroutine finish

   !> One value and the space around it.
   recursive subroutine read_value(this, reader, depth)
      type(json_t), intent(inout) :: this
      type(reader_t), intent(inout) :: reader
      integer, intent(in) :: depth
      integer :: index
      real(wp) :: x
      call skip_space(this, reader)
      if (depth > most_depth) reader%good = .false.
      if (.not. reader%good) return
      select case (here(this, reader))
      case ('{', '[')
         call read_held(this, reader, depth)
      case ('"')
         call read_string(this, reader)
      case ('-', '0':'9')
         index = begin(this, reader, is_number)
         call read_number(this, reader, x)
         this%values(index)%number = x
         call finish(this, reader, index)
      case default
         index = begin(this, reader, is_word)
         reader%at = verify(this%text(reader%at:)//' ', 'aeflnrstu') + reader%at - 1
         call finish(this, reader, index)
         reader%good = any(this%raw(index) == [character(5) :: 'true', 'false', 'null'])
      end select
      call skip_space(this, reader)
   end subroutine read_value

   !> An array or an object.
   recursive subroutine read_held(this, reader, depth)
      type(json_t), intent(inout) :: this
      type(reader_t), intent(inout) :: reader
      integer, intent(in) :: depth
      logical :: object
      character :: closing
      integer :: index
      object = here(this, reader) == '{'
      closing = merge('}', ']', object)
      index = begin(this, reader, merge(is_object, is_array, object))
      reader%at = reader%at + 1
      call skip_space(this, reader)
      if (.not. took(this, reader, closing)) then
         do
            if (object) then
               call skip_space(this, reader)
               call read_string(this, reader)
               call skip_space(this, reader)
               if (reader%good) reader%good = took(this, reader, ':')
            end if
            call read_value(this, reader, depth + 1)
            if (.not. reader%good) return
            this%values(index)%count = this%values(index)%count + 1
            if (.not. took(this, reader, ',')) exit
         end do
         reader%good = took(this, reader, closing)
      end if
      call finish(this, reader, index)
   end subroutine read_held

   subroutine read_string(this, reader)
      type(json_t), intent(inout) :: this
      type(reader_t), intent(inout) :: reader
      integer :: index
      index = begin(this, reader, is_string)
      if (reader%good) reader%good = took(this, reader, '"')
      do while (reader%good .and. here(this, reader) /= '"')
         if (iachar(here(this, reader)) < 32) reader%good = .false. ! the end of the text, too
         if (took(this, reader, '\')) then
            if (took(this, reader, 'u')) then
               reader%good = reader%at + 3 <= len(this%text)
               if (reader%good) reader%good = &
                  verify(this%text(reader%at:reader%at + 3), '0123456789abcdefABCDEF') == 0
               reader%at = reader%at + 3
            else
               reader%good = scan(here(this, reader), '"\/bfnrt') == 1
            end if
         end if
         reader%at = reader%at + 1
      end do
      if (reader%good) reader%good = took(this, reader, '"')
      call finish(this, reader, index)
   end subroutine read_string

   subroutine read_number(this, reader, x)
      type(json_t), intent(inout) :: this
      type(reader_t), intent(inout) :: reader
      real(wp), intent(out) :: x
      integer :: first, status
      logical :: sign
      first = reader%at
      sign = took(this, reader, '-')
      if (.not. took(this, reader, '0')) call read_digits(this, reader)
      if (took(this, reader, '.')) call read_digits(this, reader)
      if (scan(here(this, reader), 'eE') == 1) then
         reader%at = reader%at + 1
         if (scan(here(this, reader), '+-') == 1) reader%at = reader%at + 1
         call read_digits(this, reader)
      end if
      x = 0
      if (.not. reader%good) return
      read (this%text(first:reader%at - 1), *, iostat=status) x
      if (status /= 0) x = ieee_value(x, ieee_quiet_nan) ! longer than the runtime will read
   end subroutine read_number

   subroutine read_digits(this, reader)
      type(json_t), intent(in) :: this
      type(reader_t), intent(inout) :: reader
      integer :: first
      first = reader%at
      do while (scan(here(this, reader), '0123456789') == 1)
         reader%at = reader%at + 1
      end do
      reader%good = reader%good .and. reader%at > first
   end subroutine read_digits

   !> The text of a value as it came.
   pure function raw(this, value)
      class(json_t), intent(in) :: this
      integer, intent(in) :: value
      character(:), allocatable :: raw
      raw = this%text(this%values(value)%first:this%values(value)%last)
   end function raw

   !> Whether it is this string.
   pure logical function is(this, value, string)
      class(json_t), intent(in) :: this
      integer, intent(in) :: value
      character(*), intent(in) :: string
      is = .false.
      if (value == none) return
      associate (v => this%values(value))
         if (v%kind /= is_string .or. v%last - v%first - 1 /= len(string)) return
         is = this%text(v%first + 1:v%last - 1) == string
      end associate
   end function is

   !> The value of a key, or `none`.
   pure integer function member(this, object, key)
      class(json_t), intent(in) :: this
      integer, intent(in) :: object
      character(*), intent(in) :: key
      integer :: at, i
      member = none
      if (object == none) return
      if (this%values(object)%kind /= is_object) return
      at = object + 1
      do i = 1, this%values(object)%count
         if (this%is(at, key)) then
            member = at + 1
            return
         end if
         at = this%values(at + 1)%next
      end do
   end function member

   !> The first value of an array, the others follow by `next`; `none` unless there are `count`.
   pure integer function items(this, array, count)
      class(json_t), intent(in) :: this
      integer, intent(in) :: array, count
      items = none
      if (array == none) return
      if (this%values(array)%kind == is_array .and. this%values(array)%count == count) items = array + 1
   end function items

   !> A number, or one of the strings "inf", "-inf", "NaN". Clears `good` where it is none.
   real(wp) function number(this, value, good)
      class(json_t), intent(in) :: this
      integer, intent(in) :: value
      logical, intent(inout) :: good
      number = ieee_value(number, ieee_quiet_nan)
      if (value == none) then
         good = .false.
      else if (this%values(value)%kind == is_number) then
         number = this%values(value)%number
      else if (this%is(value, 'inf')) then
         number = ieee_value(number, ieee_positive_inf)
      else if (this%is(value, '-inf')) then
         number = ieee_value(number, ieee_negative_inf)
      else if (.not. this%is(value, 'NaN')) then
         good = .false.
      end if
   end function number

   !> A list of so many numbers. Clears `good` where it is none.
   function all_numbers(this, list, count, good) result(x)
      class(json_t), intent(in) :: this
      integer, intent(in) :: list, count
      logical, intent(inout) :: good
      real(wp) :: x(count)
      integer :: at, i
      x = 0
      at = this%items(list, count)
      good = good .and. at /= none
      if (at == none) return
      do i = 1, count
         x(i) = this%number(at, good)
         at = this%values(at)%next
      end do
   end function all_numbers

end module json
