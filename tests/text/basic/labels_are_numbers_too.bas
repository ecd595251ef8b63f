goto 20
10 print "ten"
goto 2.5
20 print "twenty"
goto 10.0
2.5 print "two and a half"
goto 1e3
1000 print "thousand"
' (finally prints twenty)
' (finally prints ten)
' (finally prints two and a half)
' (finally prints thousand)
