O1 (NEST-1: a program that calls itself fails at the 11th level)
#100=#100+1
M98 P1 (expect alarm PS0077)
M30
(finally #100=11)
