(run with: --machine lathe2)
O1 (the corner waits until the line behind it is found)
G98 G00 X20. Z0.
G01 Z-5. ,R1. F100
,A150. ,C1.
X50. Z-40. ,A170.
Z-50.
M30
(finally moves: rapid X20 Z0; line X20 Z-4.7321; cw X20.2679 Z-5.2321 @-4.7321,22; line X44.4208 Z-26.149; line X45.7681 Z-27.9999; line X50 Z-40; line X50 Z-50)
