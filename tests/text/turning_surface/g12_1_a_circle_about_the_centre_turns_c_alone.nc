(run with: --machine lathe3c)
O1 (Polar interpolation)
G98
G00X40.Z2.C0
G12.1
G03X40.C0.I-20.F200 (expect moves: ccw X40 C360 @0,0 XC)
G02X40.C0.I-20. (expect moves: cw X40 C0 @0,0 XC)
G13.1
M30
