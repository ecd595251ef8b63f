O1 (LEX-21: the head slash is a switch, the inner one an operator)
/2 #100=6/3 (expect #100=2)
M30
