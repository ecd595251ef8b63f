O1 (CTL-7: the guard does not protect the division)
#1=0
IF[[#1NE0]AND[5/#1GT1]]THEN #100=1 (expect alarm PS0112)
M30
