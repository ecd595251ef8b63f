(run with: --machine lathe2)
O1 (turning, pecks and threads: twelve passes, two of them finish)
G97 S500 M03
G00 X34. Z5.
G76 P020060 Q100 R0.05
G76 X27.4 Z-30. P1300 Q350 F2.
#100=#5001
#101=#5002
M30
(finally #100=34, #101=5)
(finally moves: rapid X34 Z5; rapid X29.3; thread X29.3 Z-30 F2; rapid X34 Z-30; rapid X34 Z5; rapid X29.01; thread X29.01 Z-30 F2; rapid X34 Z-30; rapid X34 Z5; rapid X28.7876; thread X28.7876 Z-30 F2; rapid X34 Z-30; rapid X34 Z5; rapid X28.5876; thread X28.5876 Z-30 F2; rapid X34 Z-30; rapid X34 Z5; rapid X28.3876; thread X28.3876 Z-30 F2; rapid X34 Z-30; rapid X34 Z5; rapid X28.1876; thread X28.1876 Z-30 F2; rapid X34 Z-30; rapid X34 Z5; rapid X27.9876; thread X27.9876 Z-30 F2; rapid X34 Z-30; rapid X34 Z5; rapid X27.7876; thread X27.7876 Z-30 F2; rapid X34 Z-30; rapid X34 Z5; rapid X27.5876; thread X27.5876 Z-30 F2; rapid X34 Z-30; rapid X34 Z5; rapid X27.5; thread X27.5 Z-30 F2; rapid X34 Z-30; rapid X34 Z5; rapid X27.4; thread X27.4 Z-30 F2; rapid X34 Z-30; rapid X34 Z5; rapid X27.4; thread X27.4 Z-30 F2; rapid X34 Z-30; rapid X34 Z5)
