print "begin"
goto behind
x=)
behind: x=1; print "still"
y=x y=3 ' (expect alarm LB0001 column 5)
' (finally prints begin)
' (finally prints still)
