O1 (the held move of a corner is made when an alarm comes)
G90 G01 X10. F100 ,R2.
#3000=1(STOP) (expect alarm MC3001)
M30
(finally moves: line X10)
