// The scenes A, B, C and E for POV-Ray 3.7 (it has no motion blur, so no D), chosen by Declare=Scene=1, 2, 3 or 5.
// B needs LensSamples, LensVariance (with 0, every pixel gets all samples) and LensConfidence. E includes
// bumpy_sphere.inc, which bumpy_sphere.py writes.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 3 }
background { rgb <0.2, 0.4, 0.8> }

camera {
  location <0, 0, 0>
  right x
  up y
  direction -z * 0.8660254  // 60 degrees
#if (Scene = 2)
  aperture 0.16
  focal_point <0, 0, -3>
  blur_samples LensSamples
  variance LensVariance
  confidence LensConfidence
#end
}

// A disk light of radius 0.9, 2 x 2 points for each hit: POV-Ray has no area light with one. They are jittered in cells
// of half the light's width, whose centres are this far apart.
#declare Apart = 0.9;
light_source { <2, 5, -4> rgb 0.8 area_light <Apart, 0, 0>, <0, 0, Apart>, 2, 2 circular jitter }
light_source { <-5, 5, 5> rgb 0.15 }

#declare Ground = texture { pigment { rgb 0.7 } finish { ambient 0.1 diffuse 0.9 } }
#declare Ball = texture {
  pigment { rgb <0.8, 0.3, 0.2> }
  finish { ambient 0.1 diffuse 0.8 specular 0.3 roughness 0.02 #if (Scene = 3) reflection 0.4 #end }
#if (Scene = 3)
  normal { bumps 0.25 scale 0.0001 }  // far smaller than a pixel: this is what blurs the reflection
#end
}

#declare Height = #if (Scene = 2) -2; #else -1; #end
mesh {
  triangle { <-40, Height, 10>, <40, Height, 10>, <40, Height, -60> }
  triangle { <-40, Height, 10>, <40, Height, -60>, <-40, Height, -60> }
  texture { Ground }
}

#switch (Scene)
#case (1)
#case (3)
  sphere { <0, 0, -4>, 1 texture { Ball } }
#break
#case (2)
  #for (Row, 1, 20)
    sphere { <-1.5, -1.5, -Row>, 0.5 texture { Ball } }
    sphere { <1.5, -1.5, -Row>, 0.5 texture { Ball } }
  #end
#break
#case (5)
  #include "bumpy_sphere.inc"
#end
