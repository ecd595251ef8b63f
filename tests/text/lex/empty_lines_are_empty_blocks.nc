O1 (LEX-2: several line ends in a row do nothing)
#100=1

;

#101=#100+1 (expect #101=2)
M30
