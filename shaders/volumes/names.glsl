// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Names of VTK's shader of volumes that differ between its versions, or that it computes only in
// some modes: macros, expanded where a splice uses them. RELIEVO_VOLUME_HAS_ defines, by
// vtkRelievoVolumeSplice, tell which names the text has.

//RELIEVO::Section(Dec)
// A volume's texture coordinates, such as g_dataPos (the sample), to its data and to the world.
#define RELIEVO_VOLUME_TO_DATA inverse(ip_inverseTextureDataAdjusted)
#define RELIEVO_VOLUME_TO_WORLD (in_volumeMatrix[0] * inverse(ip_inverseTextureDataAdjusted))
#define RELIEVO_VOLUME_FROM_WORLD (ip_inverseTextureDataAdjusted * in_inverseVolumeMatrix[0])

// The eye, in the volume's data space.
#ifdef RELIEVO_VOLUME_HAS_EYES
#define RELIEVO_VOLUME_EYE in_eyePosObjs[0]
#else
#define RELIEVO_VOLUME_EYE (in_inverseVolumeMatrix[0] * vec4(in_cameraPos, 1.0)).xyz
#endif

// In computeLighting(): the number of lights, and whether a light has a position. With VTK's
// default lighting, a single head light, these names do not exist.
#ifdef RELIEVO_VOLUME_HAS_LIGHT_COUNTS
#define RELIEVO_VOLUME_LIGHTS TOTAL_NUMBER_LIGHTS
#define RELIEVO_VOLUME_IS_LAMP(light) (light < NUMBER_POS_LIGHTS)
#elif defined(RELIEVO_VOLUME_HAS_LIGHT_KINDS)
#define RELIEVO_VOLUME_LIGHTS in_numberOfLights
#define RELIEVO_VOLUME_IS_LAMP(light) (in_lightPositional[light] != 0)
#endif
