(run with: --machine lathe2)
O1 (corner radius and chamfer between lines at any angle)
G97S500M03
G00X20.Z2.
G01Z-15.,R4.F.2
X40.Z-25.,C2.
Z-40.
M30
(finally moves: rapid X20 Z2; line X20 Z-13.3431; cw X22.3431 Z-16.1716 @-13.3431,28 ZX; line X37.1716 Z-23.5858; line X40 Z-27; line X40 Z-40)
