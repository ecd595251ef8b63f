(run with: --machine lathe2)
O1 (LAT-4)
G97S500M03
G00X20.Z0
G03X40.Z-10.I0K-10.F.1 (expect moves: ccw X40 Z-10 @-10,20 ZX)
M30
