// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The light of a whole environment on a surface, by nine spherical harmonics.
// R. Ramamoorthi, P. Hanrahan: An Efficient Representation for Irradiance Environment Maps,
// SIGGRAPH 2001.

// The real orthonormal harmonic number l * l + l + m (0 to 8; l up to 2) of unit direction d,
// without the Condon-Shortley phase: 1; y, z, x; xy, yz, 3 z z - 1, xz, x x - y y, each by its
// factor.
float relievoShBasis(int index, vec3 d)
{
  if (index == 0)
  {
    return float(0.282094791773878143);
  }
  if (index < 4)
  {
    return float(0.488602511902919921) * (index == 1 ? d.y : (index == 2 ? d.z : d.x));
  }
  if (index == 6)
  {
    return float(0.315391565252520006) * (float(3.0) * d.z * d.z - float(1.0));
  }
  if (index == 8)
  {
    return float(0.546274215296039535) * (d.x * d.x - d.y * d.y);
  }
  float product = index == 4 ? d.x * d.y : (index == 5 ? d.y * d.z : d.x * d.z);
  return float(1.09254843059207907) * product;
}

// Factor of a clamped cosine lobe for harmonic `index`: pi, 2 pi / 3, pi / 4.
float relievoShCosineLobe(int index)
{
  return index == 0 ? float(3.14159265358979324)
                    : (index < 4 ? float(2.09439510239319549) : float(0.785398163397448310));
}

// Irradiance on a surface with unit normal n: the integral of radiance times max(cos, 0), from the
// nine coefficients of the radiance. A Lambert surface of albedo a reflects a / pi of it. Harmonics
// above l = 2, which the coefficients lack, contribute little; with a small strong light the sum
// may fall below zero on the far side: clamp it.
vec3 relievoShIrradiance(vec3 n, vec3 coefficients[9])
{
  vec3 sum = vec3(float(0.0), float(0.0), float(0.0));
  for (int i = 0; i < 9; ++i)
  {
    sum += coefficients[i] * (relievoShCosineLobe(i) * relievoShBasis(i, n));
  }
  return sum;
}
