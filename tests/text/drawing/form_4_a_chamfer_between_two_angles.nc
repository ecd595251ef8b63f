(run with: --machine lathe2)
O1 (the lines cross, then the corner is cut off)
G98 G00 X20. Z0.
G01 ,A170. ,C2. F100
X50. Z-40. ,A135.
M30
(finally moves: rapid X20 Z0; line X30.0091 Z-28.3822; line X33.5321 Z-31.7661; line X50 Z-40)
