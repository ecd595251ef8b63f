(run with: --machine lathe2)
O1 (Second turret)
G97S500M03
G00X40.Z2.
G68 (expect assumed: X changes its sign for the second turret)
G00X50. (expect moves: rapid X-50)
G01U-10.F.2 (expect moves: line X-40)
G02X50.Z-3.R5. (expect moves: ccw X-50 Z-3 @2,-50 ZX)
G69
G00X40. (expect moves: rapid X40)
M30
