O1 (ARC-1: G91 concerns the end, not the centre)
G90 G00 X10. Y10.
G91 G02 X10. I5. F100 (expect moves: cw X20 Y10 @15,10)
M30
