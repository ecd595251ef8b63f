O1 (IF [ #1 LT #2 ] THEN #1= #2)
#1 = 3
#2= 4
IF [ #1 LT #2 ] THEN #100= #2 (expect #100=4)
G90 G0 X - [ #1 + #2 ] (expect moves: rapid X-7)
Z #2 (expect moves: rapid Z4)
WHILE [ #1 LT 6 ] DO 1
#1 = #1 + 1
END 1
GOTO 10
N 10 M 30
(finally #1=6)
