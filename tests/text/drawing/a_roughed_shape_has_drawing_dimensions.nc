(run with: --machine lathe2)
O1 (the last pass of G71 goes along them, with the allowance)
G98 G00 X70. Z2.
G71 U20. R1.
G71 P10 Q20 U0.4 W0 F100
N10 G00 X20.
G01 Z-5. (expect moves: line X20.4 Z-5)
X40. ,A150. ,R2. (expect moves: line X40.0473 Z-22.0151; ccw X40.5225 Z-22.6678 @-23.0151,36.5832)
,A170. (expect moves: line X52.2509 Z-55.9255)
N20 X60. Z-60. ,A135. (expect moves: line X60.4 Z-60)
M30
