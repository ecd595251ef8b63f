O1 (X - [ #6 + #4 .. ] with a remark before the bracket)
#6=2.
#4=3.
G90 G0 X - [ #6 + #4 (OTYEZD X) ] (expect moves: rapid X-5)
M30
