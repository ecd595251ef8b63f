O1 (EXP-6: five more fit inside)
IF[[[[[[1]]]]]EQ1]THEN #100=1 (expect #100=1)
M30
