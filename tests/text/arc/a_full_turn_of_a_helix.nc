O1 (ARC-2, ARC-8: only Z is written)
G90 G00 X5.
G03 I-5. Z-2. F100 (expect moves: ccw X5 Y0 Z-2 @0,0)
M30
