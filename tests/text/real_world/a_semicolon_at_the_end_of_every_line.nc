O1; (copied from the screen of the control)
G90 G00 X1.; (expect moves: rapid X1)
#100=1 ;
;
M30 ;
(finally #100=1)
