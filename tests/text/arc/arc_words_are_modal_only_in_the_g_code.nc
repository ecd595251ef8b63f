O1 (section 8.1: the next block needs its own centre)
G90 G02 X10. Y0 I5. F100
X20. I5. (expect moves: cw X20 Y0 @15,0)
X30. (expect alarm PS0022)
M30
