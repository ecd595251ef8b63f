print 1,2,3
print "12345678","x"
print "1234567","x"
print ,1
print 1,
print 2
print "a";
print "b","c"
' (finally printed 1       2       3|12345678        x|1234567 x|        1|1       2|a b     c|)
