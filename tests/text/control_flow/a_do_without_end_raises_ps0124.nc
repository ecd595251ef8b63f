O1 (CTL-13: found when DO is executed)
#100=1
WHILE[1EQ1]DO1 (expect alarm PS0124)
M30
(finally #100=1)
