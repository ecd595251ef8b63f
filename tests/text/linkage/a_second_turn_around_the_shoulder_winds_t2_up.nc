(run with: --machine arm4)
O0001 (T2 ends at 360; the way back unwinds it)
G01 X200. F6000.
G03 I-200. (expect moves: ccw X200 Y0 @0,0 XY)
G02 I-200. (expect moves: cw X200 Y0 @0,0 XY)
G03 I-200. (expect moves: ccw X200 Y0 @0,0 XY)
G03 I-200. (expect alarm LIMIT says T2 would stand at) (expect moves: none)
M30
(finally machine X200 Y0)
