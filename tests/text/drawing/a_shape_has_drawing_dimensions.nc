(run with: --machine lathe2)
O1 (G70 along an angle, a corner and two lines that cross)
G98 G00 X70. Z2.
G70 P10 Q20
M30
N10 G00 X20. Z0.
G01 Z-5. F100
X40. ,A150. ,R2.
,A170.
N20 X60. Z-60. ,A135.
(finally moves: rapid X70 Z2; rapid X20 Z0; line X20 Z-5; line X39.6473 Z-22.0151; ccw X40.1225 Z-22.6678 @-23.0151,36.1832; line X51.8509 Z-55.9255; line X60 Z-60; rapid X70 Z2)
