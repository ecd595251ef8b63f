(run with: --machine lathe2)
O1 (G92 with the run-out of parameter 5130 one lead)
G97S500M03
G00X24.Z4.
G92X19.2Z-20.F1.5
X18.7
X18.16
G00X40.
M30
(finally moves: rapid X24 Z4; rapid X19.2 Z4; thread X19.2 Z-18.5 F1.5; thread X22.2 Z-20 F1.5; rapid X24 Z-20; rapid X24 Z4; rapid X18.7 Z4; thread X18.7 Z-18.5 F1.5; thread X21.7 Z-20 F1.5; rapid X24 Z-20; rapid X24 Z4; rapid X18.16 Z4; thread X18.16 Z-18.5 F1.5; thread X21.16 Z-20 F1.5; rapid X24 Z-20; rapid X24 Z4; rapid X40 Z4)
