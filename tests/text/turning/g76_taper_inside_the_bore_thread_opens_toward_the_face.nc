(run with: --machine lathe2)
O1 (G76 taper, inside: the bore thread opens toward the face)
G97S500M03
G00X20.Z4.
G76P020000Q80R.04
G76X24.Z-18.R.6P900Q300F1.5
M30
(finally moves: rapid X20 Z4; rapid X24 Z4; thread X22.8 Z-18 F1.5; rapid X20 Z-18; rapid X20 Z4; rapid X24.2485 Z4; thread X23.0485 Z-18 F1.5; rapid X20 Z-18; rapid X20 Z4; rapid X24.4392 Z4; thread X23.2392 Z-18 F1.5; rapid X20 Z-18; rapid X20 Z4; rapid X24.6 Z4; thread X23.4 Z-18 F1.5; rapid X20 Z-18; rapid X20 Z4; rapid X24.76 Z4; thread X23.56 Z-18 F1.5; rapid X20 Z-18; rapid X20 Z4; rapid X24.92 Z4; thread X23.72 Z-18 F1.5; rapid X20 Z-18; rapid X20 Z4; rapid X25.08 Z4; thread X23.88 Z-18 F1.5; rapid X20 Z-18; rapid X20 Z4; rapid X25.12 Z4; thread X23.92 Z-18 F1.5; rapid X20 Z-18; rapid X20 Z4; rapid X25.2 Z4; thread X24 Z-18 F1.5; rapid X20 Z-18; rapid X20 Z4; rapid X25.2 Z4; thread X24 Z-18 F1.5; rapid X20 Z-18; rapid X20 Z4)
