O1 (ARC-9: Z is helix beside R)
G17 G02 X1. Z1. R1. F100 (expect moves: cw X1 Y0 Z1 @0.5,-0.8660)
M30
