O1 (ARC-8: half a turn down by 2)
G90 G00 X5.
G03 X-5. Y0 I-5. Z-2. F100 (expect moves: ccw X-5 Y0 Z-2 @0,0 XY F100)
M30
