// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEXRConvert.h"

#include "vtkDataArray.h"
#include "vtkSetGet.h"

#include <Imath/half.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace relievo::exr
{
namespace
{
bool IsPlusZero(double value)
{
  return value == 0.0 && !std::signbit(value);
}

bool IsMinusZero(double value)
{
  return value == 0.0 && std::signbit(value);
}

bool HasOrigin(const double origin[3])
{
  return origin[0] != 0.0 || origin[1] != 0.0 || origin[2] != 0.0;
}

template <typename T>
void Note(vtkIdType& count, Losses& losses, T value)
{
  if (losses.Overflows == 0 && losses.Inexact == 0 && losses.Rounded == 0)
  {
    losses.First = std::to_string(value);
  }
  ++count;
}

// The value to store, before it is rounded to the pixel type.
template <typename T>
auto Stored(const Component& component, const T* tuple)
{
  if constexpr (std::is_floating_point<T>::value)
  {
    const double value = tuple[component.Index];
    if (component.Code != Coding::Position || !HasOrigin(component.Origin))
    {
      return value;
    }
    const bool background = IsPlusZero(tuple[0]) && IsPlusZero(tuple[1]) && IsPlusZero(tuple[2]);
    return background ? -0.0 : value - component.Origin[component.Index];
  }
  else
  {
    return tuple[component.Index];
  }
}

template <typename T>
float ToFloat(const Component& component, const T* tuple, Losses& losses)
{
  if constexpr (std::is_same<T, float>::value)
  {
    if (component.Code != Coding::Position || !HasOrigin(component.Origin))
    {
      return tuple[component.Index]; // not through double, which quietens signalling NaNs
    }
  }
  const auto value = Stored(component, tuple);
  const float result = static_cast<float>(value);
  if constexpr (std::is_same<T, double>::value)
  {
    if (std::isfinite(value) && std::isinf(result))
    {
      Note(losses.Overflows, losses, value);
    }
    // Layers of integers are doubles because the background has no value.
    else if (component.Code == Coding::Plain && value == std::floor(value) && result != value)
    {
      Note(losses.Rounded, losses, value);
    }
  }
  if constexpr (std::is_integral<T>::value)
  {
    if (component.Code == Coding::Normalized)
    {
      return result / 255.0f;
    }
    // Every 64-bit integer and every float is exact in long double.
    if (static_cast<long double>(result) != static_cast<long double>(value))
    {
      Note(losses.Inexact, losses, value);
    }
  }
  return result;
}

template <typename T>
half ToHalf(const Component& component, const T* tuple, Losses& losses)
{
  const float value = ToFloat(component, tuple, losses);
  const half result(value);
  if (std::isfinite(value) && result.isInfinity())
  {
    Note(losses.Overflows, losses, value);
  }
  if (std::is_integral<T>::value && component.Code == Coding::Plain &&
    static_cast<float>(result) != value)
  {
    Note(losses.Inexact, losses, value);
  }
  return result;
}

template <typename T>
uint32_t ToUint(const Component& component, const T* tuple, Losses& losses)
{
  const T value = tuple[component.Index];
  if constexpr (std::is_integral<T>::value && sizeof(T) > 4)
  {
    using Limits =
      std::numeric_limits<std::conditional_t<std::is_signed<T>::value, int32_t, uint32_t>>;
    if (value < static_cast<T>(Limits::min()) || value > static_cast<T>(Limits::max()))
    {
      Note(losses.Inexact, losses, value);
    }
  }
  return static_cast<uint32_t>(value);
}

template <typename T>
void EncodeTyped(const Component& component, vtkIdType first, vtkIdType count, Imf::PixelType type,
  void* pixels, Losses& losses)
{
  const int components = component.Array->GetNumberOfComponents();
  const T* tuple = static_cast<const T*>(component.Array->GetVoidPointer(first * components));
  for (vtkIdType i = 0; i < count; ++i, tuple += components)
  {
    if (type == Imf::FLOAT)
    {
      static_cast<float*>(pixels)[i] = ToFloat(component, tuple, losses);
    }
    else if (type == Imf::HALF)
    {
      static_cast<half*>(pixels)[i] = ToHalf(component, tuple, losses);
    }
    else if constexpr (std::is_integral<T>::value)
    {
      static_cast<uint32_t*>(pixels)[i] = ToUint(component, tuple, losses);
    }
  }
}

template <typename T>
T FromUint(uint32_t pixel)
{
  if constexpr (std::is_integral<T>::value && std::is_signed<T>::value)
  {
    return static_cast<T>(static_cast<int32_t>(pixel));
  }
  else
  {
    return static_cast<T>(pixel);
  }
}

template <typename T>
T FromFloat(float pixel, Coding coding)
{
  if constexpr (std::is_integral<T>::value)
  {
    const double value =
      coding == Coding::Normalized ? std::round(double(pixel) * 255.0) : std::round(double(pixel));
    // The limits of 64-bit types are not exact in double: stays below the upper one.
    const double low = static_cast<double>(std::numeric_limits<T>::min());
    const double high = static_cast<double>(std::numeric_limits<T>::max());
    return std::isnan(value) ? T(0)
      : value <= low         ? std::numeric_limits<T>::min()
      : value >= high        ? std::numeric_limits<T>::max()
                             : static_cast<T>(value);
  }
  else
  {
    return static_cast<T>(pixel);
  }
}

template <typename T>
void DecodeTyped(
  const void* pixels, bool uint, const Component& component, vtkIdType first, vtkIdType count)
{
  const int components = component.Array->GetNumberOfComponents();
  T* to = static_cast<T*>(component.Array->GetVoidPointer(first * components)) + component.Index;
  for (vtkIdType i = 0; i < count; ++i, to += components)
  {
    *to = uint ? FromUint<T>(static_cast<const uint32_t*>(pixels)[i])
               : FromFloat<T>(static_cast<const float*>(pixels)[i], component.Code);
  }
}

template <typename T>
void DecodePositionTyped(const float* const pixels[3], vtkDataArray* array, const double origin[3],
  vtkIdType first, vtkIdType count)
{
  const bool relative = HasOrigin(origin);
  T* to = static_cast<T*>(array->GetVoidPointer(first * 3));
  for (vtkIdType i = 0; i < count; ++i)
  {
    const bool background = relative && IsMinusZero(pixels[0][i]) && IsMinusZero(pixels[1][i]) &&
      IsMinusZero(pixels[2][i]);
    for (int c = 0; c < 3; ++c)
    {
      const float pixel = pixels[c][i];
      // Adding 0 would lose the sign of -0.
      *to++ = background ? T(0)
        : origin[c] == 0 ? static_cast<T>(pixel)
                         : static_cast<T>(origin[c] + static_cast<double>(pixel));
    }
  }
}
}

//------------------------------------------------------------------------------
void Encode(const Component& component, vtkIdType first, vtkIdType count, Imf::PixelType type,
  void* pixels, Losses& losses)
{
  switch (component.Array->GetDataType())
  {
    vtkTemplateMacro(EncodeTyped<VTK_TT>(component, first, count, type, pixels, losses));
  }
}

//------------------------------------------------------------------------------
void Decode(
  const void* pixels, bool uint, const Component& component, vtkIdType first, vtkIdType count)
{
  switch (component.Array->GetDataType())
  {
    vtkTemplateMacro(DecodeTyped<VTK_TT>(pixels, uint, component, first, count));
  }
}

//------------------------------------------------------------------------------
void DecodePosition(const float* const pixels[3], vtkDataArray* array, const double origin[3],
  vtkIdType first, vtkIdType count)
{
  if (array->GetDataType() == VTK_DOUBLE)
  {
    DecodePositionTyped<double>(pixels, array, origin, first, count);
  }
  else
  {
    DecodePositionTyped<float>(pixels, array, origin, first, count);
  }
}
}
